// A line segment as a ribbon of constant width on the screen; an instance a segment, four corners each.
layout(location = 0) in vec3 a_start;
layout(location = 1) in vec3 a_end;
layout(location = 2) in vec4 a_colour;
layout(location = 3) in float a_width;  // CSS pixels

uniform mat4 u_view_projection;
uniform vec2 u_viewport;     // CSS pixels
uniform float u_pixel_ratio;
uniform float u_near;

out vec4 v_colour;
out float v_across;  // device pixels from the middle
out float v_along;   // device pixels beyond the ends are outside [0, v_length]
flat out float v_length;
flat out float v_half_width;

void main() {
  vec4 start = u_view_projection * vec4(a_start, 1.0);
  vec4 end = u_view_projection * vec4(a_end, 1.0);
  if (start.w < u_near && end.w > u_near) start = mix(start, end, (u_near - start.w) / (end.w - start.w));
  if (end.w < u_near && start.w > u_near) end = mix(end, start, (u_near - end.w) / (start.w - end.w));
  vec2 half_size = 0.5 * u_viewport * u_pixel_ratio;
  vec2 p = start.xy / start.w * half_size;
  vec2 q = end.xy / end.w * half_size;
  float span = length(q - p);
  vec2 along = span > 1e-4 ? (q - p) / span : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  float side = float(gl_VertexID & 1) * 2.0 - 1.0;
  bool at_end = gl_VertexID > 1;
  v_half_width = 0.5 * a_width * u_pixel_ratio;
  float reach = v_half_width + 1.0;
  v_across = side * reach;
  v_along = at_end ? span + reach : -reach;
  v_length = span;
  v_colour = a_colour;
  vec4 base = at_end ? end : start;
  vec2 corner = (at_end ? q : p) + across * v_across + along * (at_end ? reach : -reach);
  gl_Position = vec4(corner / half_size * base.w, base.z, base.w);
}
