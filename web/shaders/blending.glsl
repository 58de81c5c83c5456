// The blending surface on the GPU (DESIGN "Blending surface, fast path"): the model's points and partials and the
// B-function's values stand in textures that change with topology and resolution only; the local maps in one small
// table that changes each frame. S = A (p, 1), S_u = A_u (p, 1) + A (p_u, 0).
// A surface of another kind is evaluated on the CPU: its points stand in u_points, its normals in u_partials_u, and its
// colours, one a vertex, in u_hues.
uniform int u_sampled;

uniform highp sampler2D u_points;      // texel (b, a): model point of grid vertex (a, b)
uniform highp sampler2D u_partials_u;
uniform highp sampler2D u_partials_v;
uniform highp sampler2D u_blend_u;     // texel (a, 0): B(w), B'(w) delta, first local, second local
uniform highp sampler2D u_blend_v;
uniform highp sampler2D u_maps;        // texels (3j .. 3j+2, i): the rows of the 3x4 map of local (i, j)
uniform highp sampler2D u_hues;        // texel (j, i): OKLab of local (i, j)

struct SurfaceVertex {
  vec3 point;
  vec3 normal;  // of any length, oriented by the parameterisation
};

mat3x4 map_of(ivec2 local) {
  return mat3x4(texelFetch(u_maps, ivec2(3 * local.y, local.x), 0), texelFetch(u_maps, ivec2(3 * local.y + 1, local.x), 0),
                texelFetch(u_maps, ivec2(3 * local.y + 2, local.x), 0));
}

vec3 model_point(ivec2 vertex) { return texelFetch(u_points, vertex.yx, 0).xyz; }

SurfaceVertex surface_vertex(ivec2 vertex) {
  if (u_sampled == 1) return SurfaceVertex(model_point(vertex), texelFetch(u_partials_u, vertex.yx, 0).xyz);
  vec4 bu = texelFetch(u_blend_u, ivec2(vertex.x, 0), 0);
  vec4 bv = texelFetch(u_blend_v, ivec2(vertex.y, 0), 0);
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
  return SurfaceVertex(p * map, cross(su, sv));
}

// The mixture of the four hues with the very weights that blend the positions; the chroma that opposite hues would
// cancel is kept up in part, so that the mixture does not go muddy.
vec3 surface_hue(ivec2 vertex) {
  if (u_sampled == 1) return texelFetch(u_hues, vertex.yx, 0).xyz;
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
  float kept = length(lab.yz);
  float raised = mix(kept, chroma, 0.4 * smoothstep(0.0, 0.06, kept));
  return vec3(lab.x, kept > 1e-5 ? lab.yz * (raised / kept) : lab.yz);
}
