// A local patch s_ij over its support, two intervals each way, after blending.glsl. All sheets have as many vertices as the
// finest knot interval needs: in a coarser one several of them meet at a grid vertex.
uniform ivec2 u_steps;   // in the finest interval
uniform ivec2 u_last;    // last grid column and row
uniform ivec2 u_closed;  // 1 where the direction wraps
uniform vec2 u_period;   // of a direction that wraps
uniform ivec2 u_mirror;  // where a twisted seam reflects knot x to u_mirror.x - x, y likewise; negative: no twist

int start_of(int interval, int direction) { return int(texelFetch(u_grid, ivec2(interval, direction), 0).y); }

int wrapped(int x, int period) { return (x % period + period) % period; }

struct GridPlace {
  int position;  // column or row of the grid
  int turns;     // how often a closed direction has gone round to there
};

// `offset` steps of the finest interval from the knot of index `knot`.
GridPlace grid_place(int knot, int offset, int direction) {
  int steps = u_steps[direction], intervals = u_intervals[direction];
  int whole = int(floor(float(offset) / float(steps)));
  int interval = knot + whole, part = offset - whole * steps, turns = 0;
  if (u_closed[direction] == 1) {
    turns = int(floor(float(interval) / float(intervals)));
    interval -= turns * intervals;
  } else if (interval < 0 || interval >= intervals) {
    return GridPlace(interval < 0 ? 0 : u_last[direction], 0);
  }
  int start = start_of(interval, direction);
  return GridPlace(start + part * (start_of(interval + 1, direction) - start) / steps, turns);
}

// The grid position that a twisted seam reflects `position` to.
int mirrored_position(int position, int direction) {
  int reflected = start_of(u_mirror[direction], direction) - position;
  return u_closed[direction] == 1 ? wrapped(reflected, u_last[direction]) : clamp(reflected, 0, u_last[direction]);
}

// The parameter at a grid place, seen from that of the local's centre.
float from_centre(highp sampler2D blend, GridPlace place, int centre, float period) {
  float t = texelFetch(blend, ivec2(place.position, 1), 0).z + float(place.turns) * period;
  return t - texelFetch(blend, ivec2(centre, 1), 0).z;
}

struct SheetVertex {
  vec3 point;
  vec3 normal;   // of any length
  ivec2 vertex;  // of the grid
};

// Local (i, j) at `offset` steps of the finest interval from its centre.
SheetVertex sheet_vertex(ivec2 local, ivec2 offset) {
  GridPlace at_u = grid_place(local.x, offset.x, 0), at_v = grid_place(local.y, offset.y, 1);
  ivec2 vertex = ivec2(at_u.position, at_v.position);
  bvec2 mirrored = bvec2(at_v.turns != 0 && u_mirror.x >= 0, at_u.turns != 0 && u_mirror.y >= 0);
  if (mirrored.x) vertex.x = mirrored_position(vertex.x, 0);
  if (mirrored.y) vertex.y = mirrored_position(vertex.y, 1);
  if (u_kind == 1) {
    ivec2 centre = ivec2(start_of(local.x, 0), start_of(local.y, 1));
    SurfacePartials s = polynomial_local(local, vec2(from_centre(u_blend_u, at_u, centre.x, u_period.x),
                                                     from_centre(u_blend_v, at_v, centre.y, u_period.y)));
    return SheetVertex(s.point, cross(s.u, s.v), vertex);
  }
  mat3x4 map = map_of(local);
  vec3 su = vec4(texelFetch(u_partials_u, vertex.yx, 0).xyz, 0.0) * map;
  vec3 sv = vec4(texelFetch(u_partials_v, vertex.yx, 0).xyz, 0.0) * map;
  return SheetVertex(vec4(model_point(vertex), 1.0) * map, any(mirrored) ? cross(sv, su) : cross(su, sv), vertex);
}
