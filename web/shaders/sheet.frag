in vec3 v_point;
in vec3 v_normal;
flat in vec3 v_hue;
in float v_apart;
in vec2 v_support;
out vec4 colour;

uniform vec3 u_eye;
uniform float u_opacity;
uniform float u_pixel_ratio;

void main() {
  vec3 normal = normalize(v_normal);
  vec3 to_eye = normalize(u_eye - v_point);
  float facing = abs(dot(normal, to_eye));
  float edge_on = pow(1.0 - facing, 2.0);
  vec2 change = fwidth(v_support);
  vec2 inside = (1.0 - abs(v_support)) / max(change, vec2(1e-7));
  float border = 1.0 - smoothstep(0.4 * u_pixel_ratio, 1.9 * u_pixel_ratio, min(inside.x, inside.y));
  vec3 c = srgb_from_linear(linear_from_oklab(v_hue + vec3(0.06 * facing, 0.0, 0.0)));
  // Where patch and surface coincide there is nothing to see but the surface; the sheet shows where they part.
  float parted = smoothstep(0.4, 9.0, v_apart);
  float alpha = clamp(u_opacity * parted * (0.72 + 0.9 * edge_on) + border * mix(0.16, 0.75, parted), 0.0, 0.95);
  colour = vec4(c * alpha, alpha);
}
