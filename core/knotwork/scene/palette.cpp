#include "knotwork/scene/palette.h"

#include <cstdint>

namespace knotwork::scene {

namespace {

/// The first four are the page's --local-a to --local-d; then indigo, yellow, rust (--local-e) and ice, found by
/// maximizing the least OKLab distance of any pair under normal and simulated protan, deutan and tritan vision.
constexpr std::array<std::uint32_t, patch_hue_count> light{0x2f7fb8, 0xe08a1e, 0x3f9a6b, 0xb65a9c,
                                                           0x433591, 0xdfd763, 0x8a3324, 0x66d0df};
constexpr std::array<std::uint32_t, patch_hue_count> dark{0x5aa9e0, 0xf2aa4b, 0x66c092, 0xd98bc3,
                                                          0x5461bd, 0xeee9a0, 0xb8483f, 0xa1f5f4};

constexpr int positive_modulus(int a, int m) { return ((a % m) + m) % m; }

/// Offsets along the two directions of the grid, modulo 8. Neighbours differ because a step of the one is +-1 or +-2,
/// a step of the other 3, 4 or 5, and none of these, nor a sum or difference of the two, is 0 modulo 8. Over a whole
/// closed direction the steps add up to a multiple of 8, so the seam is a step like the others.
int near_offset(int index, int count) {
  const int k = positive_modulus(index, count);
  if (count == 2) return k;  // 0 1
  if (count == 3) return k;  // 0 1 2, and 6 = -2 back over the seam
  // Steps of 1, as many of them 2 as it takes to the next multiple of 8, evenly spread.
  const int total = (count + 7) / 8 * 8;
  return k * total / count % patch_hue_count;
}

int far_offset(int index, int count) {
  const int k = positive_modulus(index, count);
  if (count == 3) return 3 * k;  // 0 3 6: no seam possible, used only where there is none
  // Steps of 4; an odd count needs four of 5 to come to a multiple of 8.
  const int total = count % 2 == 0 ? 4 * count : 4 * count + 4;
  return k * total / count % patch_hue_count;
}

int grid_hue_index(std::pair<int, int> counts, std::pair<Topology, Topology> topologies, PatchIndex place) {
  const auto [i, j] = place;
  const auto [n_u, n_v] = counts;
  // Only the small steps close a ring of three.
  const bool v_near =
      n_v == 3 && (n_u != 3 || (topologies.second == Topology::closed && topologies.first == Topology::open));
  const int offset = v_near ? far_offset(i, n_u) + near_offset(j, n_v) : near_offset(i, n_u) + far_offset(j, n_v);
  return offset % patch_hue_count;
}

}  // namespace

Colour patch_hue(int hue, bool dark_scheme) {
  const auto index = static_cast<std::size_t>(positive_modulus(hue, patch_hue_count));
  const std::uint32_t rgb = dark_scheme ? dark[index] : light[index];
  const auto channel = [&](unsigned shift) { return static_cast<float>((rgb >> shift) & 0xffu) / 255.0f; };
  return {channel(16), channel(8), channel(0)};
}

int patch_hue_index(const BlendingSurfaceObject& object, PatchIndex patch) {
  return grid_hue_index({object.locals_u, object.locals_v}, {object.topology_u, object.topology_v}, patch);
}

int patch_hue_index(const BSplineSurfaceObject& object, PatchIndex point) {
  return grid_hue_index({object.rows(), object.columns()}, {object.u.topology, object.v.topology}, point);
}

}  // namespace knotwork::scene
