// One local patch as a sheet of its own; an instance a patch.
uniform mat4 u_view_projection;
uniform ivec2 u_locals;      // locals to draw: n_u, n_v
uniform float u_pixel_size;  // model units a CSS pixel covers at the target
uniform ivec2 u_only;        // the one local to draw, or (-1, -1)

out vec3 v_point;
out vec3 v_normal;
flat out vec3 v_hue;
out float v_apart;   // how far from the blending surface, in CSS pixels or so
out vec2 v_support;  // -1 .. 1 from edge to edge of the support

void main() {
  ivec2 local = u_only.x >= 0 ? u_only : ivec2(gl_InstanceID / u_locals.y, gl_InstanceID % u_locals.y);
  ivec2 size = 2 * u_steps + 1;
  ivec2 offset = ivec2(gl_VertexID / size.y, gl_VertexID % size.y) - u_steps;
  SheetVertex sheet = sheet_vertex(local, offset);
  v_point = sheet.point;
  v_normal = sheet.normal;
  v_hue = texelFetch(u_hues, local.yx, 0).xyz;
  v_support = vec2(offset) / vec2(u_steps);
  // The end of an open direction is an edge of the sheet too.
  if (u_closed.x == 0) v_support.x = sheet.vertex.x == 0 ? -1.0 : sheet.vertex.x == u_last.x ? 1.0 : v_support.x;
  if (u_closed.y == 0) v_support.y = sheet.vertex.y == 0 ? -1.0 : sheet.vertex.y == u_last.y ? 1.0 : v_support.y;
  v_apart = distance(v_point, surface_vertex(sheet.vertex).point) / u_pixel_size;
  gl_Position = u_view_projection * vec4(v_point, 1.0);
  gl_Position.z -= 2e-4 * gl_Position.w;  // in front of the surface where it coincides with it
}
