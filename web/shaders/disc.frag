in vec2 v_offset;
flat in float v_radius;
flat in vec4 v_fill;
flat in vec4 v_rim;
out vec4 colour;

uniform float u_opacity;
uniform float u_pixel_ratio;

void main() {
  float distance_from_centre = length(v_offset);
  float disc = 1.0 - smoothstep(v_radius - 0.6, v_radius + 0.6, distance_from_centre);
  float inner = 1.0 - smoothstep(v_radius - v_rim.w - 0.6, v_radius - v_rim.w + 0.6, distance_from_centre);
  float glow = 0.22 * exp(-max(distance_from_centre - v_radius, 0.0) / (1.1 * u_pixel_ratio)) * (1.0 - disc);
  vec3 c = mix(v_rim.rgb, v_fill.rgb, inner);
  // Without a fill there is the rim alone, a ring.
  float opacity = u_opacity * (v_fill.a > 0.0 ? v_fill.a : 1.0 - inner);
  float alpha = (disc + glow * (1.0 - step(v_radius + 3.0 * u_pixel_ratio, distance_from_centre))) * opacity;
  colour = vec4(c * disc * opacity, alpha);
}
