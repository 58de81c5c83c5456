in vec2 v_place;
out vec4 colour;

uniform sampler2D u_image;
uniform vec3 u_shade;     // sRGB
uniform float u_opacity;

void main() {
  float fade = 1.0 - smoothstep(0.75, 1.0, length(v_place * 2.0 - 1.0));
  float shade = texture(u_image, v_place).r;
  float alpha = clamp(u_opacity * fade * (shade * (2.0 - shade)) + dither(gl_FragCoord.xy), 0.0, 1.0);
  colour = vec4(u_shade * alpha, alpha);
}
