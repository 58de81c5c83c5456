#include "knotwork/curve/bezier_curve.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>

#include "knotwork/curve/point_check.h"

namespace knotwork {

Result<BezierCurve> BezierCurve::make(std::vector<Eigen::Vector3d> points, double start, double end) {
  if (points.empty() || points.size() > static_cast<std::size_t>(max_bezier_degree) + 1) {
    return Error{"points", "A Bezier curve has 1 to " + std::to_string(max_bezier_degree + 1) + " points."};
  }
  if (Status status = check_points(points); !status) return status.error();
  if (!std::isfinite(start)) return Error{"start", "The start must be a finite number."};
  if (!std::isfinite(end) || !(start < end)) return Error{"end", "The end must lie behind the start."};
  return BezierCurve(std::move(points), start, end);
}

BezierCurve::BezierCurve(std::vector<Eigen::Vector3d> points, double start, double end)
    : points_(std::move(points)), start_(start), end_(end) {}

double BezierCurve::share_at(double t) const { return std::clamp((t - start_) / (end_ - start_), 0.0, 1.0); }

Eigen::Vector3d BezierCurve::operator()(double t) const {
  Eigen::Vector3d point;
  evaluate(t, {&point, 1});
  return point;
}

void BezierCurve::evaluate(double t, std::span<Eigen::Vector3d> out) const {
  std::array<double, max_bezier_degree + 1> row{};
  const std::span<double> basis = std::span(row).first(points_.size());
  const double w = share_at(t), delta = 1 / (end_ - start_);
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k].setZero();
    bernstein_derivative(degree(), w, static_cast<int>(k), delta, basis);
    for (std::size_t j = 0; j < basis.size(); ++j) out[k] += basis[j] * points_[j];
  }
}

void BezierCurve::evaluate(std::span<const double> t, int order, std::span<Eigen::Vector3d> out) const {
  const std::size_t values = static_cast<std::size_t>(order) + 1;
  assert(out.size() == t.size() * values);
  for (std::size_t m = 0; m < t.size(); ++m) evaluate(t[m], out.subspan(m * values, values));
}

PointTriangle BezierCurve::de_casteljau(double t) const {
  return point_triangle(points_, [w = share_at(t)](int, int) { return w; });
}

BezierCurve BezierCurve::elevated() const {
  assert(degree() < max_bezier_degree);
  std::vector<Eigen::Vector3d> raised{points_.front()};
  for (std::size_t j = 1; j < points_.size(); ++j) {
    const double share = static_cast<double>(j) / static_cast<double>(points_.size());
    raised.emplace_back(share * points_[j - 1] + (1 - share) * points_[j]);
  }
  raised.push_back(points_.back());
  return {std::move(raised), start_, end_};
}

std::pair<BezierCurve, BezierCurve> BezierCurve::split(double t) const {
  assert(start_ < t && t < end_);
  // The two edges of de Casteljau's triangle are the polygons of the two parts.
  const PointTriangle triangle = de_casteljau(t);
  std::vector<Eigen::Vector3d> before, after;
  for (const std::vector<Eigen::Vector3d>& row : triangle) {
    before.push_back(row.front());
    after.push_back(row.back());
  }
  std::reverse(after.begin(), after.end());
  return {BezierCurve(std::move(before), start_, t), BezierCurve(std::move(after), t, end_)};
}

}  // namespace knotwork
