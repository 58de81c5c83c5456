// The surface thrown on the floor by a light from above; the nearer to the floor, the darker.
uniform int u_rows;
uniform vec4 u_floor;   // centre x, y, half size, height
uniform vec2 u_slant;   // shift of the shadow a unit of height

out float v_height;

void main() {
  ivec2 vertex = ivec2(gl_VertexID / u_rows, gl_VertexID % u_rows);
  vec3 point = surface_vertex(vertex).point;
  v_height = max(point.z - u_floor.w, 0.0);
  vec2 place = point.xy + u_slant * v_height;
  gl_Position = vec4((place - u_floor.xy) / u_floor.z, 0.0, 1.0);
}
