#include "knotwork/scene/palette.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <Eigen/Core>

namespace knotwork::scene::palette_test {
namespace {

Eigen::Vector3d linear(const Colour& srgb) {
  Eigen::Vector3d rgb;
  for (int k = 0; k < 3; ++k) {
    const double c = srgb[static_cast<std::size_t>(k)];
    rgb[k] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return rgb;
}

/// Björn Ottosson's OKLab of linear sRGB.
Eigen::Vector3d oklab(const Eigen::Vector3d& rgb) {
  Eigen::Matrix3d to_cones, to_lab;
  to_cones << 0.4122214708, 0.5363325363, 0.0514459929, 0.2119034982, 0.6806995451, 0.1073969566, 0.0883024619,
      0.2817188376, 0.6299787005;
  to_lab << 0.2104542553, 0.7936177850, -0.0040720468, 1.9779984951, -2.4285922050, 0.4505937099, 0.0259040371,
      0.7827717662, -0.8086757660;
  const Eigen::Vector3d cones = (to_cones * rgb).cwiseMax(0);
  return to_lab * Eigen::Vector3d(std::cbrt(cones[0]), std::cbrt(cones[1]), std::cbrt(cones[2]));
}

/// How a reader sees linear sRGB: Machado, Oliveira and Fernandes 2009, full severity.
struct Vision {
  const char* name;
  Eigen::Matrix3d matrix;
  double threshold;        ///< OKLab distance that any two hues keep at least
  double added_threshold;  ///< and any two that are not both among the page's four letters, which are given
};

std::array<Vision, 4> visions() {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Identity(), protan, deutan, tritan;
  protan << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
  deutan << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881;
  tritan << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900;
  return {{{"normal", normal, 0.12, 0.12},
           {"protan", protan, 0.045, 0.10},
           {"deutan", deutan, 0.065, 0.10},
           {"tritan", tritan, 0.04, 0.13}}};
}

BlendingSurfaceObject object(int n_u, int n_v, Topology u, Topology v) {
  BlendingSurfaceObject result;
  result.locals_u = n_u;
  result.locals_v = n_v;
  result.topology_u = u;
  result.topology_v = v;
  return result;
}

/// Pairs of different neighbouring patches with one hue.
int clashes(const BlendingSurfaceObject& object) {
  const auto neighbour = [](int index, int step, int count, Topology topology) {
    const int next = index + step;
    if (topology == Topology::closed) return (next + count) % count;
    return next < 0 || next >= count ? -1 : next;
  };
  int sum = 0;
  for (int i = 0; i < object.locals_u; ++i) {
    for (int j = 0; j < object.locals_v; ++j) {
      const int hue = patch_hue_index(object, {i, j});
      if (hue < 0 || hue >= patch_hue_count) return -1;
      for (auto [step_u, step_v] : {PatchIndex{1, -1}, {1, 0}, {1, 1}, {0, 1}}) {
        const int k = neighbour(i, step_u, object.locals_u, object.topology_u);
        const int l = neighbour(j, step_v, object.locals_v, object.topology_v);
        if (k < 0 || l < 0 || (k == i && l == j)) continue;
        if (patch_hue_index(object, {k, l}) == hue) ++sum;
      }
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("palette: any two hues are told apart by any common colour vision") {
  for (bool dark : {false, true}) {
    CAPTURE(dark);
    for (const Vision& vision : visions()) {
      CAPTURE(vision.name);
      double least = 1, least_added = 1;
      for (int a = 0; a < patch_hue_count; ++a) {
        for (int b = 0; b < a; ++b) {
          const auto seen = [&](int hue) {
            return oklab((vision.matrix * linear(patch_hue(hue, dark))).cwiseMax(0).cwiseMin(1));
          };
          const double distance = (seen(a) - seen(b)).norm();
          least = std::min(least, distance);
          if (a >= 4) least_added = std::min(least_added, distance);
        }
      }
      CHECK(least >= vision.threshold);
      CHECK(least_added >= vision.added_threshold);
    }
  }
}

TEST_CASE("palette: begins with the page's four letters and repeats after eight") {
  const auto byte = [](float c) { return static_cast<int>(std::lround(c * 255)); };
  const Colour a = patch_hue(0, false), d = patch_hue(3, true);
  CHECK(byte(a[0]) == 0x2f);
  CHECK(byte(a[1]) == 0x7f);
  CHECK(byte(a[2]) == 0xb8);
  CHECK(byte(d[0]) == 0xd9);
  CHECK(byte(d[1]) == 0x8b);
  CHECK(byte(d[2]) == 0xc3);
  CHECK(patch_hue(8, false) == a);
  CHECK(patch_hue(-8, false) == a);
}

TEST_CASE("palette: neighbours differ in every count and topology") {
  for (Topology u : {Topology::open, Topology::closed}) {
    for (Topology v : {Topology::open, Topology::closed}) {
      for (int n_u = min_locals; n_u <= 20; ++n_u) {
        for (int n_v = min_locals; n_v <= 20; ++n_v) {
          // All nine patches of a closed 3 x 3 touch each other: eight hues cannot do.
          if (n_u == 3 && n_v == 3 && u == Topology::closed && v == Topology::closed) continue;
          CAPTURE(n_u);
          CAPTURE(n_v);
          REQUIRE(clashes(object(n_u, n_v, u, v)) == 0);
        }
      }
    }
  }
  CHECK(clashes(object(3, 3, Topology::closed, Topology::closed)) > 0);
}

TEST_CASE("palette: large counts, each against a few of the other direction") {
  for (int n = 21; n <= max_locals; ++n) {
    CAPTURE(n);
    for (int m : {2, 3, 4, 5, 8, max_locals}) {
      if (m == max_locals && n % 20 != 8) continue;
      REQUIRE(clashes(object(n, m, Topology::closed, Topology::closed)) == 0);
      REQUIRE(clashes(object(m, n, Topology::closed, Topology::closed)) == 0);
    }
  }
}

TEST_CASE("palette: a sleeping patch and the ghost over the seam have hues too") {
  const BlendingSurfaceObject torus = object(6, 4, Topology::closed, Topology::closed);
  CHECK(patch_hue_index(torus, {6, 1}) == patch_hue_index(torus, {0, 1}));
  CHECK(patch_hue_index(torus, {2, 4}) == patch_hue_index(torus, {2, 0}));
}

TEST_CASE("palette: the points of a net have the hues of the patches of such a grid") {
  for (const int rows : {2, 3, 7}) {
    for (const int columns : {3, 4, 5}) {
      BSplineSurfaceObject net;
      net.net.assign(static_cast<std::size_t>(rows), std::vector<Eigen::Vector3d>(static_cast<std::size_t>(columns)));
      net.u.topology = Topology::closed;
      const BlendingSurfaceObject patches = object(rows, columns, Topology::closed, Topology::open);
      for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) CHECK(patch_hue_index(net, {i, j}) == patch_hue_index(patches, {i, j}));
    }
  }
}

}  // namespace knotwork::scene::palette_test
