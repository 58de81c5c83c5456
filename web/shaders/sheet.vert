// One local patch as a sheet of its own: s_ij over its support, two intervals each way; an instance a patch.
uniform mat4 u_view_projection;
uniform ivec2 u_steps;
uniform ivec2 u_last;          // last grid column and row
uniform ivec2 u_locals;        // locals to draw: n_u, n_v
uniform ivec2 u_closed;        // 1 where the direction wraps
uniform vec2 u_period;         // of a direction that wraps
uniform ivec2 u_mirror;        // where a twisted seam reflects column x to u_mirror.x - x, row y likewise; negative: no twist
uniform float u_pixel_size;    // model units a CSS pixel covers at the target
uniform ivec2 u_only;          // the one local to draw, or (-1, -1)

out vec3 v_point;
out vec3 v_normal;
flat out vec3 v_hue;
out float v_apart;   // how far from the blending surface, in CSS pixels or so
out vec2 v_support;  // -1 .. 1 from edge to edge of the support

bool goes_round(int position, int last, int closed) { return closed == 1 && (position < 0 || position >= last); }

int grid_position(int centre, int offset, int last, int closed) {
  int position = centre + offset;
  if (closed == 1) return (position % last + last) % last;
  return clamp(position, 0, last);
}

// The parameter at a grid position, seen from that of the local's centre.
float from_centre(highp sampler2D blend, int centre, int offset, int last, int closed, float period) {
  int position = centre + offset;
  float turns = closed == 1 ? floor(float(position) / float(last)) : 0.0;
  float t = texelFetch(blend, ivec2(grid_position(centre, offset, last, closed), 1), 0).z + turns * period;
  return t - texelFetch(blend, ivec2(centre, 1), 0).z;
}

void main() {
  ivec2 local = u_only.x >= 0 ? u_only : ivec2(gl_InstanceID / u_locals.y, gl_InstanceID % u_locals.y);
  ivec2 size = 2 * u_steps + 1;
  ivec2 offset = ivec2(gl_VertexID / size.y, gl_VertexID % size.y) - u_steps;
  ivec2 centre = local * u_steps;
  ivec2 vertex = ivec2(grid_position(centre.x, offset.x, u_last.x, u_closed.x),
                       grid_position(centre.y, offset.y, u_last.y, u_closed.y));
  bvec2 beyond = bvec2(goes_round(centre.x + offset.x, u_last.x, u_closed.x),
                       goes_round(centre.y + offset.y, u_last.y, u_closed.y));
  bvec2 mirrored = bvec2(beyond.y && u_mirror.x >= 0, beyond.x && u_mirror.y >= 0);
  if (mirrored.x) vertex.x = grid_position(u_mirror.x, -vertex.x, u_last.x, u_closed.x);
  if (mirrored.y) vertex.y = grid_position(u_mirror.y, -vertex.y, u_last.y, u_closed.y);
  if (u_kind == 1) {
    SurfacePartials s =
        polynomial_local(local, vec2(from_centre(u_blend_u, centre.x, offset.x, u_last.x, u_closed.x, u_period.x),
                                     from_centre(u_blend_v, centre.y, offset.y, u_last.y, u_closed.y, u_period.y)));
    v_point = s.point;
    v_normal = cross(s.u, s.v);
  } else {
    mat3x4 map = map_of(local);
    v_point = vec4(model_point(vertex), 1.0) * map;
    vec3 su = vec4(texelFetch(u_partials_u, vertex.yx, 0).xyz, 0.0) * map;
    vec3 sv = vec4(texelFetch(u_partials_v, vertex.yx, 0).xyz, 0.0) * map;
    v_normal = any(mirrored) ? cross(sv, su) : cross(su, sv);
  }
  v_hue = texelFetch(u_hues, local.yx, 0).xyz;
  v_support = vec2(offset) / vec2(u_steps);
  if (u_closed.x == 0) v_support.x = vertex.x == 0 || vertex.x == u_last.x ? sign(v_support.x + 1e-6) : v_support.x;
  if (u_closed.y == 0) v_support.y = vertex.y == 0 || vertex.y == u_last.y ? sign(v_support.y + 1e-6) : v_support.y;
  v_apart = distance(v_point, surface_vertex(vertex).point) / u_pixel_size;
  gl_Position = u_view_projection * vec4(v_point, 1.0);
  gl_Position.z -= 2e-4 * gl_Position.w;  // in front of the surface where it coincides with it
}
