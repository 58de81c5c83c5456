in vec4 v_colour;
in float v_across;
in float v_along;
flat in float v_length;
flat in float v_half_width;
out vec4 colour;

void main() {
  float beyond = max(max(-v_along, v_along - v_length), 0.0);  // round caps
  float outside = length(vec2(v_across, beyond)) - v_half_width;
  float alpha = v_colour.a * (1.0 - smoothstep(-0.5, 0.5, outside));
  colour = vec4(v_colour.rgb * alpha, alpha);
}
