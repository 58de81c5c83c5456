#include "knotwork/curve/blending_curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "knotwork/basis/bernstein.h"
#include "knotwork/basis/local_blend.h"

namespace knotwork {
namespace {

/// Value and derivatives to the highest order: scratch on the stack.
using LocalJet = std::array<Eigen::Vector3d, BlendingCurve::max_order + 1>;

constexpr double binomials[BlendingCurve::max_order + 1][BlendingCurve::max_order + 1] = {
    {1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};
/// Bounds on the length of a model's domain, so that powers of knot intervals do not overflow.
constexpr double shortest_domain = 1e-9, longest_domain = 1e9;
/// Bound on a model's derivatives at a knot.
constexpr double largest_coordinate = 1e100;
/// The most radians that an arc turns through over its domain: beyond, not a digit of the angle's sine would be right.
constexpr double largest_turn = 1e9;

void map_jet(const Eigen::Affine3d& map, std::span<Eigen::Vector3d> jet) {
  for (std::size_t j = 0; j < jet.size(); ++j) {
    const Eigen::Vector3d image = map.linear() * jet[j];
    jet[j] = j == 0 ? image + map.translation() : image;
  }
}

/// The Taylor polynomial without its constant term, f(x) = sum_{j>=1} derivatives[j-1] x^j/j!, and its derivatives.
void evaluate_taylor(std::span<const Eigen::Vector3d> derivatives, double x, std::span<Eigen::Vector3d> out) {
  for (std::size_t k = 0; k < out.size(); ++k) {
    // Horner's rule for sum_{j>=k} derivatives[j-1] x^(j-k)/(j-k)!.
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t j = derivatives.size(); j >= std::max<std::size_t>(k, 1); --j) {
      sum = derivatives[j - 1] + x / static_cast<double>(j + 1 - k) * sum;
    }
    out[k] = k == 0 ? x * sum : sum;
  }
}

/// With the angular velocity omega = kappa v, f(x) = velocity p(x) + normal_acceleration q(x), p = sin(omega x)/omega,
/// q' = p: entire in omega, so that a straight line is no special case.
void evaluate_arc(const Eigen::Vector3d& velocity, const Eigen::Vector3d& normal_acceleration, double x,
                  std::span<Eigen::Vector3d> out) {
  const double speed = velocity.norm();
  const double omega = speed > 0 ? normal_acceleration.norm() / speed : 0;
  const auto chord = [x](double turn) { return turn == 0 ? x : x * (std::sin(turn) / turn); };
  const double half = chord(omega * x / 2), sine = std::sin(omega * x), cosine = std::cos(omega * x);
  // q, p, p', p'', p'''.
  const double q_p[] = {half * half / 2, chord(omega * x), cosine, -omega * sine, -omega * omega * cosine};
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = q_p[k + 1] * velocity + q_p[k] * normal_acceleration;
}

/// Velocity and normal acceleration at a centre from the first two derivatives; both 0 where the model stands still.
void keep_arc_data(double width, std::span<Eigen::Vector3d> derivatives) {
  Eigen::Vector3d &velocity = derivatives[0], &acceleration = derivatives[1];
  const double speed = velocity.norm();
  if (speed > 0) {
    const Eigen::Vector3d tangent = velocity / speed;
    acceleration -= tangent.dot(acceleration) * tangent;
  }
  if (!(speed > 0) || acceleration.norm() * width > largest_turn * speed) {
    velocity.setZero();
    acceleration.setZero();
  }
}

/// How many vectors a local keeps of the model at its centre: the point; the derivatives to the degree; two of them.
std::size_t centre_data_size(const LocalCurves& shape) {
  if (shape.kind == LocalCurveKind::sub_curve) return 1;
  return shape.kind == LocalCurveKind::arc ? 2 : static_cast<std::size_t>(shape.degree);
}

Status check_model(const ModelCurve& model, const LocalCurves& shape) {
  const double length = model.end() - model.start();
  if (!std::isfinite(length) || length < shortest_domain || length > longest_domain) {
    return Error{"model", "The domain of the model curve must be between 1e-9 and 1e9 long."};
  }
  if (shape.kind == LocalCurveKind::bezier_hermite) {
    const int most = std::min(model.max_order(), max_bezier_degree);
    if (shape.degree < 1 || shape.degree > most) {
      return Error{"shape.degree", "The degree of local Bezier curves over this model must lie between 1 and " +
                                       std::to_string(most) + "."};
    }
    return success();
  }
  const int needed = shape.kind == LocalCurveKind::arc ? 2 : BlendingCurve::max_order;
  if (model.max_order() < needed) {
    return Error{"model", "These local curves need " + std::to_string(needed) + " derivatives of the model curve."};
  }
  return success();
}

bool usable_coordinates(std::span<const Eigen::Vector3d> vectors) {
  for (const Eigen::Vector3d& vector : vectors) {
    for (const double x : vector) {
      if (!std::isfinite(x) || std::abs(x) > largest_coordinate) return false;
    }
  }
  return true;
}

}  // namespace

BlendingCurve::BlendingCurve(ModelCurve model, KnotVector knots, BlendingFunction blending, LocalCurves shape,
                             std::vector<Eigen::Affine3d> locals, std::vector<Eigen::Vector3d> centre_data)
    : model_(std::move(model)),
      knots_(std::move(knots)),
      blending_(std::move(blending)),
      shape_(shape),
      locals_(std::move(locals)),
      model_maps_(locals_.size()),
      centre_data_(std::move(centre_data)) {
  for (int k = 0; k < knots_.count(); ++k) set_local(k, local(k));
}

Result<BlendingCurve> BlendingCurve::make(ModelCurve model, KnotVector knots, BlendingFunction blending,
                                          LocalCurves shape, std::vector<Eigen::Affine3d> locals) {
  if (const Status ok = check_model(model, shape); !ok) return ok.error();
  const ModelDirection direction{"model curve", "curve", "", model.start(), model.end(), model.topology()};
  if (const Status ok = check_blending_knots("knots", knots, direction); !ok) return ok.error();
  if (const Status ok = check_local_maps(locals, static_cast<std::size_t>(knots.count()), "curve"); !ok) {
    return ok.error();
  }
  const std::size_t kept = centre_data_size(shape);
  std::vector<Eigen::Vector3d> data;
  std::vector<Eigen::Vector3d> jet(kept + 1);
  for (int k = 0; k < knots.count(); ++k) {
    model.evaluate(knots[k + 1], jet);
    if (!usable_coordinates(jet)) {
      return Error{"model", "The model curve must have finite derivatives of reasonable size at the knots."};
    }
    const bool with_point = shape.kind == LocalCurveKind::sub_curve;
    const std::span<Eigen::Vector3d> used = std::span(jet).subspan(with_point ? 0 : 1, kept);
    if (shape.kind == LocalCurveKind::arc) keep_arc_data(knots[k + 2] - knots[k], used);
    data.insert(data.end(), used.begin(), used.end());
  }
  return BlendingCurve(std::move(model), std::move(knots), std::move(blending), shape, std::move(locals),
                       std::move(data));
}

std::vector<Eigen::Affine3d> BlendingCurve::unmoved_locals(const ModelCurve& model, const KnotVector& knots) {
  std::vector<Eigen::Affine3d> locals;
  locals.reserve(static_cast<std::size_t>(knots.count()));
  for (int k = 0; k < knots.count(); ++k) locals.emplace_back(Eigen::Translation3d(model(knots[k + 1])));
  return locals;
}

void BlendingCurve::set_local(int k, const Eigen::Affine3d& map) {
  assert(k >= 0 && k < knots_.count() && usable_local_map(map));
  const std::size_t index = static_cast<std::size_t>(k);
  locals_[index] = map;
  if (shape_.kind == LocalCurveKind::sub_curve) {
    model_maps_[index] = map * Eigen::Translation3d(-centre_data(k).front());
  }
}

std::span<const Eigen::Vector3d> BlendingCurve::centre_data(int k) const {
  const std::size_t kept = centre_data_size(shape_);
  return std::span(centre_data_).subspan(static_cast<std::size_t>(k) * kept, kept);
}

/// l_k and derivatives at t_{k+1} + x, for the kinds that need nothing but their centre.
void BlendingCurve::evaluate_shape(int k, double x, std::span<Eigen::Vector3d> out) const {
  const std::span<const Eigen::Vector3d> data = centre_data(k);
  if (shape_.kind == LocalCurveKind::arc) {
    evaluate_arc(data[0], data[1], x, out);
  } else {
    evaluate_taylor(data, x, out);
  }
  map_jet(local(k), out);
}

void BlendingCurve::evaluate_local(int k, double t, std::span<Eigen::Vector3d> out) const {
  assert(k >= 0 && k < knots_.count() && out.size() <= max_order + 1);
  if (shape_.kind != LocalCurveKind::sub_curve) return evaluate_shape(k, t - centre(k), out);
  model_.evaluate(t, out);
  if (!out.empty()) out[0] -= centre_data(k).front();
  map_jet(local(k), out);
}

/// evaluate() with a hint for the span of t; returns that span.
int BlendingCurve::evaluate_near(int hint, double t, std::span<Eigen::Vector3d> out) const {
  assert(out.size() <= max_order + 1);
  const double reduced = knots_.reduced(t);
  const LocalBlend blend = local_blend(knots_, blending_, reduced, hint);
  LocalJet first_jet, second_jet;
  const std::span<Eigen::Vector3d> first = std::span(first_jet).first(out.size());
  const std::span<Eigen::Vector3d> second = std::span(second_jet).first(out.size());
  if (shape_.kind == LocalCurveKind::sub_curve) {
    // A wrapped local is local 0 at reduced - P. Its M^ is applied to model(reduced) instead: the same, because the
    // model repeats wherever closing is allowed.
    model_.evaluate(reduced, first);
    std::copy(first.begin(), first.end(), second.begin());
    map_jet(model_maps_[static_cast<std::size_t>(blend.first)], first);
    map_jet(model_maps_[static_cast<std::size_t>(blend.second)], second);
  } else {
    // Seen from the knots at either end, a wrapped local needs no special care.
    evaluate_shape(blend.first, reduced - knots_[blend.span()], first);
    evaluate_shape(blend.second, reduced - knots_[blend.span() + 1], second);
  }
  for (std::size_t k = 0; k < out.size(); ++k) {
    // A weighted sum and not "first plus weight times difference": a weight of exactly 0 or 1 must select exactly.
    out[k] = blend.one[0] * first[k] + blend.other[0] * second[k];
    for (std::size_t j = 1; j <= k; ++j) out[k] += binomials[k][j] * blend.other[j] * (second[k - j] - first[k - j]);
  }
  return blend.span();
}

void BlendingCurve::evaluate(double t, std::span<Eigen::Vector3d> out) const { evaluate_near(1, t, out); }

Eigen::Vector3d BlendingCurve::operator()(double t) const {
  Eigen::Vector3d point;
  evaluate(t, {&point, 1});
  return point;
}

void BlendingCurve::evaluate(std::span<const double> t, int order, std::span<Eigen::Vector3d> out) const {
  const std::size_t values = static_cast<std::size_t>(order) + 1;
  assert(out.size() == t.size() * values);
  int span = 1;
  for (std::size_t m = 0; m < t.size(); ++m) span = evaluate_near(span, t[m], out.subspan(m * values, values));
}

void BlendingCurve::evaluate_two_curves(double t, std::span<Eigen::Vector3d> out) const {
  const double reduced = knots_.reduced(t);
  const int i = knots_.span(reduced);
  const LocalBlend blend = local_blend(knots_, blending_, reduced, i);
  for (Eigen::Vector3d& derivative : out) derivative.setZero();
  for (int a = 0; a <= 1; ++a) {
    const bool wraps = i - 1 + a == knots_.count();
    LocalJet jet;
    const std::span<Eigen::Vector3d> local = std::span(jet).first(out.size());
    evaluate_local(wraps ? 0 : i - 1 + a, wraps ? reduced - knots_.period() : reduced, local);
    const std::array<double, 4>& weight = a == 0 ? blend.one : blend.other;
    for (std::size_t k = 0; k < out.size(); ++k) {
      for (std::size_t j = 0; j <= k; ++j) out[k] += binomials[k][j] * weight[j] * local[k - j];
    }
  }
}

std::array<BlendingCurve::Weight, 2> BlendingCurve::weights(double t) const {
  const LocalBlend blend = local_blend(knots_, blending_, knots_.reduced(t), 1);
  return {{{blend.first, blend.one[0]}, {blend.second, blend.other[0]}}};
}

}  // namespace knotwork
