// Colour is mixed in OKLab, lit in linear sRGB and written as sRGB.

vec3 linear_from_oklab(vec3 lab) {
  float l = lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z;
  float m = lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z;
  float s = lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z;
  vec3 c = vec3(l * l * l, m * m * m, s * s * s);
  return max(vec3(4.0767416621 * c.x - 3.3077115913 * c.y + 0.2309699292 * c.z,
                  -1.2684380046 * c.x + 2.6097574011 * c.y - 0.3413193965 * c.z,
                  -0.0041960863 * c.x - 0.7034186147 * c.y + 1.7076147010 * c.z), 0.0);
}

vec3 srgb_from_linear(vec3 c) {
  c = max(c, 0.0);
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

vec3 linear_from_srgb(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }

// Half a grey level of noise, against banding in slow gradients.
float dither(vec2 pixel) { return (fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0; }
