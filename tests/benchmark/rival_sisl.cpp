// SISL, SINTEF's spline library: s1221 for points in any order, s1542 for sorted ones, s1506 for grids.

#include <memory>

#include <sisl.h>

#include "benchmark/rivals.h"
#include "benchmark/works.h"

namespace knotwork::benchmark {
namespace {

struct Free {
  void operator()(SISLCurve* curve) const { freeCurve(curve); }
  void operator()(SISLSurf* surface) const { freeSurf(surface); }
};
constexpr int polynomial = 1, dimension = 3, copies = 1, order = 4;

std::vector<double> knots_of(const KnotVector& knots) { return {knots.knots().begin(), knots.knots().end()}; }
std::vector<double> numbers(std::span<const Eigen::Vector3d> points) {
  std::vector<double> list;
  for (const Eigen::Vector3d& point : points) list.insert(list.end(), {point.x(), point.y(), point.z()});
  return list;
}

void add_curves(std::vector<Kernel>& rows) {
  for (const CurveWork& work : curve_works()) {
    const BSplineCurve curve = work.curve();
    std::vector<double> knots = knots_of(curve.knots()), points = numbers(curve.points());
    const std::shared_ptr<SISLCurve> other(
        newCurve(curve.knots().count(), order, knots.data(), points.data(), polynomial, dimension, copies), Free());
    rows.push_back(curve_contender(work, "SISL s1221", [=](std::span<const double> t, Eigen::Vector3d* out) {
      int left = 0, status = 0;
      for (const double at : t) {
        s1221(other.get(), work.order, at, &left, out->data(), &status);
        out += work.order + 1;
      }
    }));
    if (work.order > 0 || !work.sorted) continue;
    rows.push_back(curve_contender(work, "SISL s1542", [=](std::span<const double> t, Eigen::Vector3d* out) {
      int status = 0;
      // It does not write through the pointer.
      s1542(other.get(), static_cast<int>(t.size()), const_cast<double*>(t.data()), out->data(), &status);
    }));
  }
}

void add_surfaces(std::vector<Kernel>& rows) {
  const BSplineSurface surface = surface_work();
  std::vector<double> knots_u = knots_of(surface.knots_u()), knots_v = knots_of(surface.knots_v()), points;
  // SISL's first parameter runs fastest.
  for (int j = 0; j < surface.knots_v().count(); ++j) {
    for (int i = 0; i < surface.knots_u().count(); ++i) {
      const Eigen::Vector3d& c = surface.point(i, j);
      points.insert(points.end(), {c.x(), c.y(), c.z()});
    }
  }
  const std::shared_ptr<SISLSurf> other(
      newSurf(surface.knots_u().count(), surface.knots_v().count(), order, order, knots_u.data(), knots_v.data(),
              points.data(), polynomial, dimension, copies),
      Free());
  for (const bool frames : {false, true}) {
    const auto work = std::make_shared<GridWork>(surface_grid(frames));
    const std::size_t vectors = frames ? 4 : 1, side = work->side;
    const auto values = std::make_shared<std::vector<double>>(3 * vectors * side * side);
    const auto normals = std::make_shared<std::vector<double>>(3 * side * side);
    const auto run = [=] {
      int status = 0;
      s1506(other.get(), frames ? 1 : 0, static_cast<int>(side), work->u.data(), static_cast<int>(side), work->v.data(),
            values->data(), normals->data(), &status);
    };
    const auto at = [=](std::size_t k) {
      const std::size_t place = k % side * side + k / side;
      Frame frame = Frame::Zero();
      // With first partials: S, S_u, S_v.
      const std::size_t stride = frames ? 9 : 3;
      for (std::size_t c = 0; c < stride; ++c)
        frame(static_cast<Eigen::Index>(c % 3), static_cast<Eigen::Index>(c / 3)) = (*values)[place * stride + c];
      for (std::size_t c = 0; c < 3; ++c) frame(static_cast<Eigen::Index>(c), 3) = (*normals)[place * 3 + c];
      frame.col(3).normalize();
      return frame;
    };
    rows.push_back(surface_contender(*work, "SISL s1506", run, at));
  }
}

}  // namespace

void add_sisl(std::vector<Kernel>& rows) {
  add_curves(rows);
  add_surfaces(rows);
}

}  // namespace knotwork::benchmark
