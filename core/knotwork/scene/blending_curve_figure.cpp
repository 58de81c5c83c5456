#include "knotwork/scene/blending_curve_figure.h"

#include <algorithm>
#include <cmath>

#include "knotwork/basis/local_blend.h"
#include "knotwork/curve/curve_measures.h"
#include "knotwork/curve/moving_frame.h"
#include "knotwork/scene/blending_curve_edits.h"
#include "knotwork/scene/curve_sampling.h"

namespace knotwork::scene {

namespace {

constexpr double strand_tolerance = 2e-4;  // of the model's size
constexpr int fewest_interval_steps = 32;  // the blending itself is no straight line over an interval
constexpr int frame_steps = 24;            // of the frame from one centre to the next

/// What the samples of the model depend on.
bool same_intervals(const BlendingCurveObject& a, const BlendingCurveObject& b) {
  return a.model == b.model && a.topology == b.topology && a.locals == b.locals && a.knots == b.knots;
}

bool same_shape(const BlendingCurveObject& a, const BlendingCurveObject& b) {
  return same_intervals(a, b) && a.local_kind == b.local_kind && a.local_degree == b.local_degree &&
         a.blending == b.blending && a.blending_parameter == b.blending_parameter;
}

/// The locals as the model has them, not moved by anything.
std::vector<LocalFrame> resting_locals(const CatalogueCurve& model, const KnotVector& knots) {
  const std::vector<Eigen::Matrix3d> frames = local_frames(model, knots);
  std::vector<LocalFrame> locals;
  for (int k = 0; k < knots.count(); ++k) {
    Eigen::Vector3d centre;
    evaluate(model, knots[k + 1], {&centre, 1});
    locals.push_back({centre, frames[static_cast<std::size_t>(k)], {}, {}});
  }
  return locals;
}

LocalFrame posed(LocalFrame local, int k, const BlendingCurveObject& object, const Animation& animation) {
  const auto edit = object.edits.find({k, 0});
  local.edit = edit == object.edits.end() ? PatchEdit{} : edit->second;
  local.motion = patch_motion(animation, {k, 0});
  return local;
}

/// Edits and motion into locals and curve.
void pose(BlendingCurve& curve, std::vector<LocalFrame>& locals, const BlendingCurveObject& object,
          const Animation& animation) {
  for (int k = 0; k < curve.knots().count(); ++k) {
    LocalFrame& local = locals[static_cast<std::size_t>(k)];
    local = posed(local, k, object, animation);
    curve.set_local(k, local_map(local));
  }
}

}  // namespace

BlendingCurve build_curve(const BlendingCurveObject& object, const Animation& animation) {
  BlendingCurve curve = unmoved_curve(object);
  std::vector<LocalFrame> locals = resting_locals(object.model, curve.knots());
  pose(curve, locals, object, animation);
  return curve;
}

std::vector<Eigen::Matrix3d> local_frames(const CatalogueCurve& model, const KnotVector& knots) {
  CurveView curve = view_of(model);
  curve.topology = Topology::open;  // the frame need not come round, and both ends of a period may be centres
  std::vector<double> centres;
  centres.reserve(static_cast<std::size_t>(knots.count()));
  for (int k = 0; k < knots.count(); ++k) centres.push_back(std::clamp(knots[k + 1], curve.start, curve.end));
  std::array<Eigen::Vector3d, 4> jet;
  curve.evaluate(centres.front(), jet);
  MovingFrameOptions options;
  options.first_normal = frenet_frame(jet, 1e-9 / drawn_size(curve)).normal;
  options.steps = frame_steps;
  std::vector<Eigen::Matrix3d> frames;
  for (const MovingFrame& frame : rotation_minimising_frames(curve, centres, options).value().frames) {
    frames.emplace_back();
    frames.back() << frame.tangent, frame.normal.cross(frame.tangent), frame.normal;
  }
  return frames;
}

BlendingCurveFigure::BlendingCurveFigure(const BlendingCurveObject& object, const Animation& animation)
    : curve(unmoved_curve(object)), made_from_(object) {
  sample_intervals();
  update(object, animation);
}

void BlendingCurveFigure::update(const BlendingCurveObject& object, const Animation& animation) {
  if (!same_shape(object, made_from_)) {
    curve = unmoved_curve(object);
    const bool resample = !same_intervals(object, made_from_);
    made_from_ = object;
    if (resample) sample_intervals();
  }
  made_from_ = object;
  pose(curve, locals, object, animation);
  evaluate_samples();
  evaluate_strands();

  const KnotVector& knots = curve.knots();
  t = std::lerp(knots.start(), knots.end(), object.parameter);
  point = curve(t);
  weights = curve.weights(t);
  const double reduced = knots.reduced(t);
  for (std::size_t k = 0; k < 2; ++k) {
    // The second one of a closed curve's last interval is local 0, a period earlier.
    const bool wrapped = k == 1 && weights[1].local < weights[0].local;
    curve.evaluate_local(weights[k].local, wrapped ? reduced - knots.period() : reduced, {&local_points[k], 1});
  }
}

void BlendingCurveFigure::sample_intervals() {
  const KnotVector& knots = curve.knots();
  const CurveView model = view_of(made_from_.model);
  size = drawn_size(model);
  locals = resting_locals(made_from_.model, knots);
  intervals_.clear();
  const double all_steps = least_steps(made_from_.model);
  for (int i = 1; i <= knots.last_span(); ++i) {
    const double share = (knots[i + 1] - knots[i]) / (model.end - model.start);
    const int least = std::max(fewest_interval_steps, static_cast<int>(std::ceil(all_steps * share)));
    intervals_.push_back(drawing_parameters(model, knots[i], knots[i + 1], least, strand_tolerance * size));
  }
}

void BlendingCurveFigure::evaluate_samples() {
  const KnotVector& knots = curve.knots();
  samples.clear();
  mixtures.clear();
  for (std::size_t interval = 0; interval < intervals_.size(); ++interval) {
    const int first = static_cast<int>(interval), i = first + 1;
    const int second = i == knots.count() ? 0 : i;
    for (const double at : intervals_[interval]) {
      const double weight = curve.blending()(translation_and_scaling(knots, 1, i, at))[0];
      // From this interval's two locals, at its end too.
      Eigen::Vector3d a, b;
      curve.evaluate_local(first, at, {&a, 1});
      curve.evaluate_local(second, second == 0 ? at - knots.period() : at, {&b, 1});
      samples.push_back({at, (1 - weight) * a + weight * b});
      mixtures.push_back({curve.model()(at), first, second, weight});
    }
  }
}

void BlendingCurveFigure::evaluate_strands() {
  strands.clear();
  for (int k = 0; k < curve.knots().count(); ++k) strands.push_back(strand(k));
}

/// It is the second one of the interval that ends at its centre and the first one of the next.
BlendingCurveFigure::Strand BlendingCurveFigure::strand(int k) const {
  const KnotVector& knots = curve.knots();
  Strand strand;
  const auto add = [&](int i, bool rises, double shift) {
    if (i < 1 || i > knots.last_span()) return;
    for (const double at : intervals_[static_cast<std::size_t>(i) - 1]) {
      const double b = curve.blending()(translation_and_scaling(knots, 1, i, at))[0];
      strand.points.emplace_back();
      curve.evaluate_local(k, at - shift, {&strand.points.back(), 1});
      strand.weights.push_back(rises ? b : 1 - b);
    }
  };
  if (k > 0) add(k, true, 0);
  if (k == 0 && knots.closed()) add(knots.count(), true, knots.period());
  add(k + 1, false, 0);
  return strand;
}

LocalFrame BlendingCurveFigure::local(int k, const BlendingCurveObject& object, const Animation& animation) const {
  return posed(locals[static_cast<std::size_t>(k)], k, object, animation);
}

double BlendingCurveFigure::weight(std::size_t i, int k) const {
  const Mixture& mixture = mixtures[i];
  return (mixture.first == k ? 1 - mixture.weight : 0) + (mixture.second == k ? mixture.weight : 0);
}

}  // namespace knotwork::scene
