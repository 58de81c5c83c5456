// The grids that are evaluated by the row, points and frames, against the single points of the same surfaces.

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "knotwork/surface/surface_measures.h"
#include "property/surface_cases.h"
#include "unit/bspline_cases.h"

namespace knotwork::surface_grid_test {
using namespace test;
namespace {

/// The error bound that the headers state.
constexpr double stated = 1e-13;

/// So many parameters inside the domain, at its ends and beyond, and knots.
std::vector<double> parameters(const KnotVector& knots, std::size_t count, bool sorted, std::mt19937& random) {
  std::uniform_real_distribution<double> place(knots.start(), knots.end());
  std::vector<double> t{knots.end(), knots.start() - 0.3 * knots.period(), knots[knots.degree() + 1],
                        knots.start() + 1.4 * knots.period()};
  t.resize(std::min(count, t.size()));
  while (t.size() < count) t.push_back(place(random));
  if (sorted) std::sort(t.begin(), t.end());
  return t;
}

struct Sizes {
  double s, su, sv;
};

bool same_frame(const SurfaceFrame& frame, const SurfaceJet& jet, const Sizes& sizes) {
  // The normal from the frame's own partials: nearly parallel ones make their errors larger, and no error of its own.
  const Eigen::Vector3d normal = unit_normal({frame.s, frame.su, frame.sv, jet.suu, jet.suv, jet.svv});
  return (frame.s - jet.s).norm() <= stated * sizes.s && (frame.su - jet.su).norm() <= stated * sizes.su &&
         (frame.sv - jet.sv).norm() <= stated * sizes.sv && (frame.normal - normal).norm() <= stated;
}

/// Frames, and points where the surface has such a grid, at all pairs.
template <class Surface, class SizesAt>
bool same_as_single(const Surface& surface, const std::vector<double>& u, const std::vector<double>& v,
                    const SizesAt& sizes_at) {
  std::vector<SurfaceFrame> frames(u.size() * v.size());
  surface.evaluate_grid(u, v, std::span(frames));
  bool same = true;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const double a = u[k / v.size()], b = v[k % v.size()];
    same = same && same_frame(frames[k], surface.evaluate(a, b), sizes_at(a, b));
  }
  if constexpr (std::is_same_v<Surface, BSplineSurface>) {
    std::vector<Eigen::Vector3d> points(frames.size());
    surface.evaluate_grid(u, v, std::span(points));
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double a = u[k / v.size()], b = v[k % v.size()];
      same = same && (points[k] - surface.evaluate(a, b).s).norm() <= stated * sizes_at(a, b).s;
    }
  }
  return same;
}

/// What the terms of a spline surface's point and partials can add up to.
auto spline_sizes(const BSplineSurface& surface) {
  double largest = 0;
  for (const Eigen::Vector3d& point : surface.points()) largest = std::max(largest, point.norm());
  return [&surface, largest](double u, double v) {
    const double in_u = largest * basis_size(surface.knots_u(), u, 0), in_v = basis_size(surface.knots_v(), v, 0);
    return Sizes{in_u * in_v, largest * basis_size(surface.knots_u(), u, 1) * in_v,
                 in_u * basis_size(surface.knots_v(), v, 1)};
  };
}

BSplineSurface random_surface(int p, int q, Ends u, Ends v, std::mt19937& random) {
  KnotVector knots_u = random_knots(p, p + 4, u, random), knots_v = random_knots(q, q + 3, v, random);
  std::vector<Eigen::Vector3d> points = random_points(static_cast<std::size_t>((p + 4) * (q + 3)), random);
  return BSplineSurface::make(std::move(knots_u), std::move(knots_v), std::move(points)).value();
}

constexpr Ends all_ends[] = {Ends::clamped, Ends::unclamped, Ends::closed};

}  // namespace

TEST_CASE("rows of a spline surface's grid are its single points, all ends and degrees") {
  std::mt19937 random(61);
  for (int degree = 1; degree <= 9; ++degree) {
    for (const Ends ends_u : all_ends) {
      for (const Ends ends_v : all_ends) {
        const BSplineSurface surface = random_surface(1 + (degree + 3) % 9, degree, ends_u, ends_v, random);
        const bool sorted = degree % 2 == 0;
        CAPTURE(degree);
        CHECK(same_as_single(surface, parameters(surface.knots_u(), 5, sorted, random),
                             parameters(surface.knots_v(), 41, sorted, random), spline_sizes(surface)));
      }
    }
  }
}

TEST_CASE("rows of any length: fewer than lanes, a piece and its neighbours, several pieces") {
  std::mt19937 random(62);
  const BSplineSurface surface = random_surface(3, 3, Ends::clamped, Ends::closed, random);
  for (const std::size_t count : {1U, 2U, 3U, 7U, 8U, 9U, 63U, 64U, 65U, 71U, 128U, 150U}) {
    CAPTURE(count);
    for (const bool sorted : {true, false})
      CHECK(same_as_single(surface, {0.3 * surface.knots_u().end()},
                           parameters(surface.knots_v(), count, sorted, random), spline_sizes(surface)));
  }
  std::vector<SurfaceFrame> none;
  surface.evaluate_grid({}, {}, std::span(none));
}

TEST_CASE("the comparison sees a control point that is off by 1e-11") {
  std::mt19937 random(63);
  const BSplineSurface surface = random_surface(3, 3, Ends::clamped, Ends::clamped, random);
  std::vector<Eigen::Vector3d> net(surface.points().begin(), surface.points().end());
  net[8].z() += 1e-11;
  const BSplineSurface other = BSplineSurface::make(surface.knots_u(), surface.knots_v(), net).value();
  const std::vector<double> u = parameters(surface.knots_u(), 20, true, random);
  const std::vector<double> v = parameters(surface.knots_v(), 20, true, random);
  std::vector<SurfaceFrame> frames(400);
  other.evaluate_grid(u, v, std::span(frames));
  int different = 0;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const double a = u[k / 20], b = v[k % 20];
    different += same_frame(frames[k], surface.evaluate(a, b), spline_sizes(surface)(a, b)) ? 0 : 1;
  }
  CHECK(different > 20);
}

TEST_CASE("at a pole the grid's normal is the limit that unit_normal takes") {
  // A quarter of a cap: the first row is one point.
  std::vector<Eigen::Vector3d> net(4, Eigen::Vector3d(0, 0, 1));
  for (int i = 1; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) net.emplace_back(i * std::cos(0.4 * j), i * std::sin(0.4 * j), 1 - 0.1 * i * i);
  }
  const KnotVector knots = KnotVector::uniform(3, 4, Topology::open, 0, 1).value();
  const BSplineSurface surface = BSplineSurface::make(knots, knots, net).value();
  const std::vector<double> u{0, 0.5}, v{0, 0.25, 0.5, 1};
  std::vector<SurfaceFrame> frames(8);
  surface.evaluate_grid(u, v, std::span(frames));
  for (std::size_t k = 0; k < frames.size(); ++k) {
    CHECK(frames[k].normal.norm() == doctest::Approx(1).epsilon(1e-14));
    CHECK((frames[k].normal - unit_normal(surface.evaluate(u[k / 4], v[k % 4]))).norm() < 1e-12);
  }
  CHECK(surface.evaluate(0, 0.5).sv.norm() == 0);
}

TEST_CASE("rows of a blending surface's grid are its single points, every topology, model and B-function") {
  std::mt19937 random(64);
  for (const SurfaceCase& item : surface_cases()) {
    CAPTURE(item.name);
    const BlendingSurface& surface = item.surface;
    // Partials grow with the steepness of B over an interval; the terms are as large as the partials of all locals.
    const auto sizes = [&](double u, double v) {
      const SurfaceJet jet = surface.evaluate(u, v);
      return Sizes{4 + jet.s.norm(), 40 + jet.su.norm(), 40 + jet.sv.norm()};
    };
    CHECK(same_as_single(surface, parameters(surface.knots_u(), 6, true, random),
                         parameters(surface.knots_v(), 70, true, random), sizes));
    CHECK(same_as_single(surface, parameters(surface.knots_u(), 4, false, random),
                         parameters(surface.knots_v(), 13, false, random), sizes));
  }
}

TEST_CASE("a blending surface's grid selects a local exactly at its centre") {
  const ModelSurface model = Sheet{};
  const SurfaceDomain over = domain(model);
  const KnotVector knots = KnotVector::uniform(1, 5, Topology::closed, over.u.start, over.u.end).value();
  const BlendingSurface surface =
      moved(unmoved(model, knots, knots, BlendingFunction::make(BlendingKind::polynomial2).value()), 7);
  std::vector<double> centres;
  centres.reserve(5);
  for (int k = 0; k < 5; ++k) centres.push_back(knots[k + 1]);
  std::vector<SurfaceFrame> frames(25);
  surface.evaluate_grid(centres, centres, std::span(frames));
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      const Eigen::Vector3d local = surface.model_map(i, j) * evaluate(model, knots[i + 1], knots[j + 1]).s;
      CHECK((frames[static_cast<std::size_t>(5 * i + j)].s - local).norm() < 1e-15);
    }
  }
}

TEST_CASE("twisted seams, Bezier-Hermite locals and poles of the model have their frames too") {
  std::mt19937 random(65);
  const auto check_frames = [&](const BlendingSurface& surface) {
    const auto sizes = [&](double, double) { return Sizes{10, 100, 100}; };
    CHECK(same_as_single(surface, parameters(surface.knots_u(), 6, true, random),
                         parameters(surface.knots_v(), 20, true, random), sizes));
  };
  const BlendingFunction b = BlendingFunction::make(BlendingKind::polynomial2).value();
  const auto knots_over = [](const Interval& range, int n, Topology topology) {
    return KnotVector::uniform(1, n, topology, range.start, range.end).value();
  };
  for (const char* id : {"moebius", "sphere"}) {
    CAPTURE(std::string(id));
    const ModelSurface model = make_catalogue_surface(id).value();
    const SurfaceDomain over = domain(model);
    const auto topology = [](Closure closure) { return closure == Closure::open ? Topology::open : Topology::closed; };
    check_frames(moved(unmoved(model, knots_over(over.u, 4, topology(over.closure_u)),
                               knots_over(over.v, 4, topology(over.closure_v)), b),
                       3));
  }
  const ModelSurface torus = torus_surface();
  const SurfaceDomain over = domain(torus);
  const KnotVector u = knots_over(over.u, 4, Topology::closed), v = knots_over(over.v, 3, Topology::closed);
  check_frames(BlendingSurface::make(torus, u, v, b, BlendingSurface::unmoved_locals(torus, u, v),
                                     {LocalSurfaceKind::bezier_hermite, 2, 3})
                   .value());
}

}  // namespace knotwork::surface_grid_test
