uniform mat4 u_view_projection;
uniform vec4 u_floor;  // centre x, y, half size, height

out vec2 v_place;

void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
  v_place = corner;
  gl_Position = u_view_projection * vec4(u_floor.xy + (corner * 2.0 - 1.0) * u_floor.z, u_floor.w, 1.0);
}
