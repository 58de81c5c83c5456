// knotwork_contest_samples FOLDER: the works for rivals in other languages, as works.json, and beside it the exact
// values that they are held to, from long double: rows of doubles, of this machine's byte order.

#include <cstdio>
#include <filesystem>
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

/// Every so many of the works' parameters: JavaScript's rivals are timed at these, SciPy at all.
constexpr std::size_t step = 5;

/// Rows of numbers, as a file that works.json names.
class Samples {
 public:
  Samples(std::filesystem::path folder, std::string name) : path_(std::move(folder) / name), name_(std::move(name)) {}

  void add(double t) { numbers_.push_back(t); }
  void add(const PrecisePoint& value) {
    for (const Precise x : value) numbers_.push_back(static_cast<double>(x));
  }
  /// The file's name.
  std::string write() const {
    std::ofstream file(path_, std::ios::binary);
    file.exceptions(std::ios::failbit | std::ios::badbit);
    file.write(reinterpret_cast<const char*>(numbers_.data()),
               static_cast<std::streamsize>(numbers_.size() * sizeof(double)));
    return name_;
  }

 private:
  std::filesystem::path path_;
  std::string name_;
  std::vector<double> numbers_;
};

/// Knots, control points, Bezier pieces, and rows of t, c, c', c''.
json curve_of(const CurveWork& work, const std::filesystem::path& folder) {
  const BSplineCurve curve = work.curve();
  json pieces = json::array();
  for (const BezierCurve& piece : curve.bezier_pieces()) pieces.push_back(net(piece.points()));
  Samples samples(folder, "curve-" + std::to_string(work.points) + ".f64");
  const std::vector<double> t = parameters(0, 1, curve_parameters);
  for (std::size_t k = 0; k < t.size(); k += step) {
    samples.add(t[k]);
    for (const PrecisePoint& value : precise_curve<3>(curve, t[k])) samples.add(value);
  }
  return {{"knots", curve.knots().knots()},
          {"points", net(curve.points())},
          {"pieces", pieces},
          {"samples", samples.write()}};
}

/// Rows of u, v, S, S_u, S_v, v running fastest.
json surface_of(const std::filesystem::path& folder) {
  const BSplineSurface surface = surface_work();
  const GridWork grid = surface_grid(true);
  Samples samples(folder, "surface.f64");
  for (std::size_t a = 0; a < grid.side; a += step) {
    const PreciseRow row(surface, grid.u[a]);
    for (std::size_t b = 0; b < grid.side; b += step) {
      const PreciseFrame frame = row(grid.v[b]);
      samples.add(grid.u[a]);
      samples.add(grid.v[b]);
      for (Eigen::Index c = 0; c < 3; ++c) samples.add(frame.col(c));
    }
  }
  return {{"knots", surface.knots_u().knots()}, {"points", net(surface.points())}, {"samples", samples.write()}};
}

}  // namespace
}  // namespace knotwork::benchmark

int main(int argc, char** argv) {
  using namespace knotwork::benchmark;
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  nlohmann::json all = {{"curves", nlohmann::json::object()}, {"surface", surface_of(folder)}};
  for (const CurveWork& work : curve_works()) {
    const std::string points = std::to_string(work.points);
    if (!all["curves"].contains(points)) all["curves"][points] = curve_of(work, folder);
  }
  std::ofstream file(folder / "works.json");
  file << all.dump();
  return file.good() ? 0 : 1;
}
