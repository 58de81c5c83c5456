// The surface on the stage, in one of four ways (SurfaceTextures), of which the first three cost the CPU nothing a vertex:
// what belongs to a vertex, or to a column or row of vertices, stands in textures that change with topology and resolution
// only, and what moves in one small table.
// 0, a blending surface of sub-surfaces (DESIGN "Blending surface, fast path"): the model's points and partials, the
//    B-function's values, and the local maps. S = A (p, 1), S_u = A_u (p, 1) + A (p_u, 0).
// 1, of Bezier-Hermite locals: they share no model point. Their polynomials stand in a texture of coefficients, each
//    local's under its own map, and the four are summed with the product rule.
// 2, a B-spline surface: basis functions with slopes, and the net.
// 3, a surface evaluated on the CPU: its points, its normals in u_partials_u, one hue for all.
uniform int u_kind;
uniform ivec2 u_degrees;  // of Bezier-Hermite locals or of the B-spline surface

uniform highp sampler2D u_points;      // texel (b, a): model point of grid vertex (a, b); texel (j, i): control point
uniform highp sampler2D u_partials_u;
uniform highp sampler2D u_partials_v;
// Texel (a, 0): B(w), B'(w) delta, first local, second local; (a, 1): u minus the first's centre, the second's, u.
// Of a B-spline surface (a, 0): the first function that is not 0; (a, 1 + k): the k-th from there and its slope.
uniform highp sampler2D u_blend_u;
uniform highp sampler2D u_blend_v;
uniform highp sampler2D u_coefficients;  // texel (j (d_v+1) + q, i (d_u+1) + p): of x^p y^q of local (i, j)
uniform highp sampler2D u_maps;        // texels (3j .. 3j+2, i): the rows of the 3x4 map of local (i, j)
uniform highp sampler2D u_hues;        // texel (j, i): OKLab of local or control point (i, j)
// Row 0 of u, 1 of v. Texel a: where column a lies, counted in knot intervals; the first column of interval a.
uniform highp sampler2D u_grid;
uniform ivec2 u_intervals;  // how many knot intervals each direction has

struct SurfaceVertex {
  vec3 point;
  vec3 normal;  // of any length, oriented by the parameterisation
};

// Where partials are parallel there is none; what rounding leaves of their product would be noise.
vec3 normal_of(vec3 su, vec3 sv) {
  vec3 normal = cross(su, sv);
  return dot(normal, normal) > 1e-9 * dot(su, su) * dot(sv, sv) ? normal : vec3(0.0);
}

mat3x4 map_of(ivec2 local) {
  return mat3x4(texelFetch(u_maps, ivec2(3 * local.y, local.x), 0), texelFetch(u_maps, ivec2(3 * local.y + 1, local.x), 0),
                texelFetch(u_maps, ivec2(3 * local.y + 2, local.x), 0));
}

// Where a vertex lies, counted in knot intervals.
vec2 knot_place(ivec2 vertex) {
  return vec2(texelFetch(u_grid, ivec2(vertex.x, 0), 0).x, texelFetch(u_grid, ivec2(vertex.y, 1), 0).x);
}

vec3 model_point(ivec2 vertex) { return texelFetch(u_points, vertex.yx, 0).xyz; }

struct SurfacePartials {
  vec3 point, u, v;
};

// Bezier-Hermite local (i, j) at its centre plus `at`, by Horner's rule in both directions.
SurfacePartials polynomial_local(ivec2 local, vec2 at) {
  SurfacePartials sum = SurfacePartials(vec3(0.0), vec3(0.0), vec3(0.0));
  ivec2 first = local * (u_degrees + 1);
  for (int p = u_degrees.x; p >= 0; --p) {
    vec3 f = vec3(0.0), f_v = vec3(0.0);
    for (int q = u_degrees.y; q >= 0; --q) {
      f_v = at.y * f_v + f;
      f = at.y * f + texelFetch(u_coefficients, ivec2(first.y + q, first.x + p), 0).xyz;
    }
    sum.u = at.x * sum.u + sum.point;
    sum.point = at.x * sum.point + f;
    sum.v = at.x * sum.v + f_v;
  }
  mat3x4 map = map_of(local);
  return SurfacePartials(vec4(sum.point, 1.0) * map, vec4(sum.u, 0.0) * map, vec4(sum.v, 0.0) * map);
}

SurfaceVertex polynomial_vertex(ivec2 vertex, vec4 bu, vec4 bv) {
  vec2 at_u = texelFetch(u_blend_u, ivec2(vertex.x, 1), 0).xy;
  vec2 at_v = texelFetch(u_blend_v, ivec2(vertex.y, 1), 0).xy;
  SurfacePartials sum = SurfacePartials(vec3(0.0), vec3(0.0), vec3(0.0));
  for (int k = 0; k < 4; ++k) {
    bool far_u = (k & 1) == 1, far_v = (k & 2) == 2;
    SurfacePartials s = polynomial_local(ivec2(far_u ? bu.w : bu.z, far_v ? bv.w : bv.z),
                                         vec2(far_u ? at_u.y : at_u.x, far_v ? at_v.y : at_v.x));
    vec2 wu = far_u ? bu.xy : vec2(1.0 - bu.x, -bu.y);
    vec2 wv = far_v ? bv.xy : vec2(1.0 - bv.x, -bv.y);
    sum.point += wu.x * wv.x * s.point;
    sum.u += wv.x * (wu.y * s.point + wu.x * s.u);
    sum.v += wu.x * (wv.y * s.point + wv.x * s.v);
  }
  return SurfaceVertex(sum.point, normal_of(sum.u, sum.v));
}

// Control point (i, j) from the first one that counts: a closed direction goes round.
ivec2 net_texel(ivec2 first, int i, int j) { return (first.yx + ivec2(j, i)) % textureSize(u_points, 0); }

ivec2 first_functions(ivec2 vertex) {
  return ivec2(texelFetch(u_blend_u, ivec2(vertex.x, 0), 0).x, texelFetch(u_blend_v, ivec2(vertex.y, 0), 0).x);
}

SurfaceVertex net_vertex(ivec2 vertex) {
  ivec2 first = first_functions(vertex);
  SurfacePartials sum = SurfacePartials(vec3(0.0), vec3(0.0), vec3(0.0));
  for (int i = 0; i <= u_degrees.x; ++i) {
    vec3 row = vec3(0.0), row_v = vec3(0.0);
    for (int j = 0; j <= u_degrees.y; ++j) {
      vec3 c = texelFetch(u_points, net_texel(first, i, j), 0).xyz;
      vec2 bv = texelFetch(u_blend_v, ivec2(vertex.y, 1 + j), 0).xy;
      row += bv.x * c;
      row_v += bv.y * c;
    }
    vec2 bu = texelFetch(u_blend_u, ivec2(vertex.x, 1 + i), 0).xy;
    sum.point += bu.x * row;
    sum.u += bu.y * row;
    sum.v += bu.x * row_v;
  }
  return SurfaceVertex(sum.point, normal_of(sum.u, sum.v));
}

SurfaceVertex surface_vertex(ivec2 vertex) {
  if (u_kind == 2) return net_vertex(vertex);
  if (u_kind == 3) return SurfaceVertex(model_point(vertex), texelFetch(u_partials_u, vertex.yx, 0).xyz);
  vec4 bu = texelFetch(u_blend_u, ivec2(vertex.x, 0), 0);
  vec4 bv = texelFetch(u_blend_v, ivec2(vertex.y, 0), 0);
  if (u_kind == 1) return polynomial_vertex(vertex, bu, bv);
  ivec2 first = ivec2(bu.z, bv.z);
  ivec2 second = ivec2(bu.w, bv.w);
  mat3x4 m00 = map_of(first);
  mat3x4 m10 = map_of(ivec2(second.x, first.y));
  mat3x4 m01 = map_of(ivec2(first.x, second.y));
  mat3x4 m11 = map_of(second);
  mat3x4 near_v = m00 + bu.x * (m10 - m00);
  mat3x4 far_v = m01 + bu.x * (m11 - m01);
  mat3x4 map = near_v + bv.x * (far_v - near_v);
  mat3x4 map_u = bu.y * (m10 - m00 + bv.x * (m11 - m01 - m10 + m00));
  mat3x4 map_v = bv.y * (far_v - near_v);

  vec4 p = vec4(model_point(vertex), 1.0);
  vec4 pu = vec4(texelFetch(u_partials_u, vertex.yx, 0).xyz, 0.0);
  vec4 pv = vec4(texelFetch(u_partials_v, vertex.yx, 0).xyz, 0.0);
  vec3 su = p * map_u + pu * map;
  vec3 sv = p * map_v + pv * map;
  return SurfaceVertex(p * map, normal_of(su, sv));
}

// A mixture of hues, whose mean chroma is `chroma`: what opposite hues cancel of it is kept up in part, so that the
// mixture does not go muddy.
vec3 raised_hue(vec3 lab, float chroma) {
  float kept = length(lab.yz);
  float raised = mix(kept, chroma, 0.4 * smoothstep(0.0, 0.06, kept));
  return vec3(lab.x, kept > 1e-5 ? lab.yz * (raised / kept) : lab.yz);
}

vec3 net_hue(ivec2 vertex) {
  ivec2 first = first_functions(vertex);
  vec4 sum = vec4(0.0);
  for (int i = 0; i <= u_degrees.x; ++i) {
    float bu = texelFetch(u_blend_u, ivec2(vertex.x, 1 + i), 0).x;
    for (int j = 0; j <= u_degrees.y; ++j) {
      vec3 hue = texelFetch(u_hues, net_texel(first, i, j), 0).xyz;
      sum += bu * texelFetch(u_blend_v, ivec2(vertex.y, 1 + j), 0).x * vec4(hue, length(hue.yz));
    }
  }
  return raised_hue(sum.xyz, sum.w);
}

// Hues are mixed with the very weights that mix the positions.
vec3 surface_hue(ivec2 vertex) {
  if (u_kind == 3) return texelFetch(u_hues, ivec2(0), 0).xyz;
  if (u_kind == 2) return net_hue(vertex);
  vec4 bu = texelFetch(u_blend_u, ivec2(vertex.x, 0), 0);
  vec4 bv = texelFetch(u_blend_v, ivec2(vertex.y, 0), 0);
  ivec2 first = ivec2(bu.z, bv.z);
  ivec2 second = ivec2(bu.w, bv.w);
  vec3 h00 = texelFetch(u_hues, first.yx, 0).xyz;
  vec3 h10 = texelFetch(u_hues, ivec2(first.y, second.x), 0).xyz;
  vec3 h01 = texelFetch(u_hues, ivec2(second.y, first.x), 0).xyz;
  vec3 h11 = texelFetch(u_hues, second.yx, 0).xyz;
  vec3 lab = mix(mix(h00, h10, bu.x), mix(h01, h11, bu.x), bv.x);
  float chroma = mix(mix(length(h00.yz), length(h10.yz), bu.x), mix(length(h01.yz), length(h11.yz), bu.x), bv.x);
  return raised_hue(lab, chroma);
}
