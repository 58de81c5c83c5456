// The surface thrown on the floor by a light from above; the nearer to the floor, the darker.
uniform int u_rows;
uniform vec4 u_floor;   // centre x, y, half size, height

out float v_height;

void main() {
  ivec2 vertex = ivec2(gl_VertexID / u_rows, gl_VertexID % u_rows);
  vec3 point = surface_vertex(vertex).point;
  v_height = max(point.z - u_floor.w, 0.0);
  gl_Position = vec4((point.xy - u_floor.xy) / u_floor.z, 0.0, 1.0);
}
