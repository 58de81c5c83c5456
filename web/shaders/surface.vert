uniform mat4 u_view_projection;
uniform int u_rows;
uniform int u_shading;  // as in surface.frag
uniform highp sampler2D u_curvature;  // texel (b, a): of vertex (a, b)

// Centroid: at silhouettes a pixel's centre lies off the triangle, and extrapolated values would sparkle.
// Not for what derivatives are taken of: centroids jump from pixel to pixel.
centroid out vec3 v_point;
centroid out vec3 v_normal;
centroid out vec3 v_hue;
out vec3 v_place;
out vec2 v_grid;
out vec2 v_knot;
out float v_curvature;

void main() {
  ivec2 vertex = ivec2(gl_VertexID / u_rows, gl_VertexID % u_rows);
  SurfaceVertex surface = surface_vertex(vertex);
  v_point = v_place = surface.point;
  float size = length(surface.normal);
  v_normal = size > 0.0 ? surface.normal / size : vec3(0.0);
  v_hue = surface_hue(vertex);
  v_grid = vec2(vertex);
  v_knot = knot_place(vertex);
  v_curvature = u_shading == 3 ? texelFetch(u_curvature, vertex.yx, 0).x : 0.0;
  gl_Position = u_view_projection * vec4(surface.point, 1.0);
}
