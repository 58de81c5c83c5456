in vec2 v_place;
out vec4 colour;

uniform vec3 u_stage;       // sRGB
uniform vec3 u_stage_edge;
uniform vec2 u_centre;      // of the light, in the unit square
uniform float u_aspect;

void main() {
  vec2 offset = (v_place - u_centre) * vec2(max(u_aspect, 0.6), 1.0);
  float share = smoothstep(0.05, 0.95, length(offset));
  vec3 c = mix(u_stage, u_stage_edge, share);
  colour = vec4(c + dither(gl_FragCoord.xy), 1.0);
}
