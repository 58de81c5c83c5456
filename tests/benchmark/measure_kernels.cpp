#include <memory>
#include <numbers>

#include "benchmark/kernel.h"
#include "knotwork/curve/arc_length.h"
#include "knotwork/curve/closest_point.h"
#include "knotwork/curve/curve_measures.h"
#include "knotwork/surface/closest_surface_point.h"
#include "knotwork/surface/surface_area.h"
#include "knotwork/surface/surface_measures.h"

namespace knotwork::benchmark {
namespace {

BSplineCurve measured_curve() {
  return BSplineCurve::make(KnotVector::uniform(3, 40, Topology::open, 0, 1).value(), wavy_points(40)).value();
}

}  // namespace

std::vector<Kernel> measure_kernels() {
  std::vector<Kernel> rows;
  const auto curve = std::make_shared<const BSplineCurve>(measured_curve());

  // Against the length of a fine polygon, whose error falls with the square of its legs.
  const auto length = std::make_shared<double>(0);
  rows.push_back({"arc length, cubic, 40 points", 1, [=] { *length = arc_length(curve_view(*curve)); },
                  [=] {
                    double sum = 0;
                    const int legs = 200000;
                    Eigen::Vector3d before = (*curve)(0);
                    for (int k = 1; k <= legs; ++k) {
                      const Eigen::Vector3d here = (*curve)(static_cast<double>(k) / legs);
                      sum += (here - before).norm();
                      before = here;
                    }
                    return std::abs(*length - sum) / sum;
                  },
                  1e-8});

  const auto to_length = std::make_shared<const ArcLength>(curve_view(*curve));
  const auto places = std::make_shared<std::vector<double>>();
  rows.push_back({"100 parameters at equal arc lengths", 100, [=] { *places = to_length->equidistant(100); },
                  [=] {
                    double worst = 0;
                    for (std::size_t k = 0; k < places->size(); ++k) {
                      const double expected = to_length->length() * static_cast<double>(k) / 99;
                      worst = std::max(worst, std::abs(to_length->at((*places)[k]) - expected));
                    }
                    return worst / to_length->length();
                  },
                  2e-12});  // as ArcLength::parameter_at promises

  // Against the nearest of many points of the curve, which is at most a little farther.
  const Eigen::Vector3d seen(0.3, 0.2, 0.9);
  const auto nearest = std::make_shared<ClosestPoint>();
  rows.push_back({"closest point, cubic, 40 points", 1,
                  [=] { *nearest = closest_point(curve_view(*curve), seen).value(); },
                  [=] {
                    double least = HUGE_VAL;
                    for (int k = 0; k <= 100000; ++k)
                      least = std::min(least, ((*curve)(static_cast<double>(k) / 100000) - seen).norm());
                    return nearest->distance <= least ? (least - nearest->distance) / least : HUGE_VAL;
                  },
                  1e-6});

  // Curvature and torsion at 1000 points, against each other's definition by the Frenet frame.
  constexpr std::size_t count = 1000;
  const auto derivatives = std::make_shared<std::vector<Eigen::Vector3d>>(4 * count);
  curve->evaluate(parameters(0, 1, count), 3, *derivatives);
  const auto bends = std::make_shared<std::vector<Eigen::Vector3d>>(count);
  rows.push_back({"curvature and torsion", count,
                  [=] {
                    for (std::size_t k = 0; k < count; ++k) {
                      const auto c = std::span(*derivatives).subspan(4 * k, 4);
                      (*bends)[k] = {curvature(c), torsion(c), speed(c)};
                    }
                  },
                  [=] {
                    std::vector<Eigen::Vector3d> expected;
                    for (std::size_t k = 0; k < count; ++k) {
                      const FrenetFrame frame = frenet_frame(std::span(*derivatives).subspan(4 * k, 4));
                      expected.emplace_back(frame.curvature, frame.torsion, frame.speed);
                    }
                    return difference(*bends, expected);
                  }});

  // A torus of radii R and r: its area is 4 pi^2 R r; curvatures against each other's sum and product.
  const Sheet sheet{.closed_radius_u = 1, .closed_radius_v = 0.4};
  const ModelSurface torus = sheet;
  const double known = 4 * std::numbers::pi * std::numbers::pi * sheet.closed_radius_u * sheet.closed_radius_v;
  const auto area = std::make_shared<double>(0);
  rows.push_back({"surface area, torus", 1, [=] { *area = surface_area(surface_view(torus)).value; },
                  [=] { return std::abs(*area - known) / known; }, 1e-12});
  const auto jets = std::make_shared<std::vector<SurfaceJet>>(count);
  for (std::size_t k = 0; k < count; ++k) (*jets)[k] = evaluate(torus, 0.01 * static_cast<double>(k), 0.7);
  const auto curvatures = std::make_shared<std::vector<SurfaceCurvature>>(count);
  rows.push_back({"surface curvatures", count,
                  [=] {
                    for (std::size_t k = 0; k < count; ++k) (*curvatures)[k] = curvature((*jets)[k]);
                  },
                  [=] {
                    double worst = 0;
                    for (const SurfaceCurvature& c : *curvatures)
                      worst = std::max(
                          {worst, std::abs(c.k_max * c.k_min - c.gaussian), std::abs(c.k_max + c.k_min - 2 * c.mean)});
                    return worst;
                  },
                  1e-13});
  const auto foot = std::make_shared<ClosestSurfacePoint>();
  rows.push_back({"closest point, torus", 1,
                  [=] { *foot = closest_point(surface_view(torus), Eigen::Vector3d(2, 0.1, 0.3)).value(); },
                  [=] {
                    double least = HUGE_VAL;
                    for (int i = 0; i < 1000; ++i) {
                      for (int j = 0; j < 1000; ++j) {
                        const Eigen::Vector3d point =
                            evaluate(torus, i * 0.00628318 - 3.14159, j * 0.00628318 - 3.14159).s;
                        least = std::min(least, (point - Eigen::Vector3d(2, 0.1, 0.3)).norm());
                      }
                    }
                    return foot->distance <= least ? (least - foot->distance) / least : HUGE_VAL;
                  },
                  1e-4});
  return rows;
}

}  // namespace knotwork::benchmark
