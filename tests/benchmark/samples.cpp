// knotwork_contest_samples FILE: the works for rivals in other languages, with points of them in long double, as JSON.

#include <cstdio>
#include <fstream>

#include <nlohmann/json.hpp>

#include "benchmark/reference.h"
#include "benchmark/works.h"

namespace knotwork::benchmark {
namespace {

using nlohmann::json;

template <class Vector>
json numbers(const Vector& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}
json net(std::span<const Eigen::Vector3d> points) {
  json list = json::array();
  for (const Eigen::Vector3d& point : points) list.push_back(numbers(point));
  return list;
}

/// Knots, control points, Bezier pieces, and [t, c, c', c''] at some of the work's parameters.
json curve_of(const CurveWork& work) {
  const BSplineCurve curve = work.curve();
  json pieces = json::array(), samples = json::array();
  for (const BezierCurve& piece : curve.bezier_pieces()) pieces.push_back(net(piece.points()));
  const std::vector<double> t = parameters(0, 1, curve_parameters);
  for (std::size_t k = 0; k < t.size(); k += t.size() / 50) {
    const auto values = precise_curve(curve, t[k]);
    samples.push_back({t[k], numbers(values[0]), numbers(values[1]), numbers(values[2])});
  }
  return {{"knots", curve.knots().knots()}, {"points", net(curve.points())}, {"pieces", pieces}, {"samples", samples}};
}

/// [u, v, S, S_u, S_v] at some places of the grid.
json surface_of() {
  const BSplineSurface surface = surface_work();
  json samples = json::array();
  const std::vector<double> t = parameters(0, 1, 1000);
  for (std::size_t k = 0; k < t.size(); k += 37) {
    const double u = t[k], v = t[(7 * k + 3) % t.size()];
    const PreciseFrame frame = precise_surface(surface, u, v);
    samples.push_back({u, v, numbers(frame.col(0)), numbers(frame.col(1)), numbers(frame.col(2))});
  }
  return {{"knots", surface.knots_u().knots()}, {"points", net(surface.points())}, {"samples", samples}};
}

}  // namespace
}  // namespace knotwork::benchmark

int main(int argc, char** argv) {
  using namespace knotwork::benchmark;
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FILE\n", argv[0]);
    return 2;
  }
  nlohmann::json all = {{"curves", nlohmann::json::object()}, {"surface", surface_of()}};
  for (const CurveWork& work : curve_works()) {
    const std::string points = std::to_string(work.points);
    if (!all["curves"].contains(points)) all["curves"][points] = curve_of(work);
  }
  std::ofstream file(argv[1]);
  file << all.dump();
  return file.good() ? 0 : 1;
}
