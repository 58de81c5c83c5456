#pragma once

#include <array>
#include <vector>

#include "knotwork/curve/blending_curve.h"
#include "knotwork/later.h"
#include "knotwork/scene/curve_sample.h"
#include "knotwork/scene/local_frame.h"

namespace knotwork::scene {

/// F_k: the own axes of local k at its centre: the model's tangent T, N x T, and N, the rotation-minimising normal that
/// begins as Frenet's. Unlike Frenet's own it is there where the curve is straight, and does not jump at inflections.
std::vector<Eigen::Matrix3d> local_frames(const CatalogueCurve& model, const KnotVector& knots);

/// The blending curve that a document means, at its clock: M_k from edits and motion. Precondition: the object is valid.
BlendingCurve build_curve(const BlendingCurveObject& object, const Animation& animation);

/// What stands on the stage of a blending curve: everything that is drawn of it, held or read off.
struct BlendingCurveFigure {
  /// Precondition: the object is valid.
  BlendingCurveFigure(const BlendingCurveObject& object, const Animation& animation);
  /// The same for a changed object or clock; what only edits, clock or parameter change is done again, no more.
  void update(const BlendingCurveObject& object, const Animation& animation);

  /// What a sample is made of: the locals `first` and `second` with the weights 1 - weight and weight, over the model's
  /// point.
  struct Mixture {
    Eigen::Vector3d model;
    int first, second;
    double weight;
  };
  /// A local curve over its support (t_k, t_{k+2}), each place with its weight in the blending curve.
  struct Strand {
    std::vector<Eigen::Vector3d> points;
    std::vector<double> weights;
  };

  BlendingCurve curve;
  std::vector<LocalFrame> locals;    ///< as the document has them
  std::vector<CurveSample> samples;  ///< interval by interval: where one ends the next begins, with weights of its own
  std::vector<Mixture> mixtures;     ///< of the samples
  std::vector<Strand> strands;       ///< one for each local
  double size = 1;                   ///< of the model: half the diagonal of its box

  double t = 0;  ///< where the two locals are shown
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  std::array<BlendingCurve::Weight, 2> weights;  ///< at t
  std::array<Eigen::Vector3d, 2> local_points;   ///< of the two locals at t

  /// Local k as a document has it that may be a few edits ahead of this figure.
  KNOTWORK_LATER LocalFrame local(int k, const BlendingCurveObject& object, const Animation& animation) const;
  /// The weight of local k at samples[i].
  double weight(std::size_t i, int k) const;

 private:
  void sample_intervals();
  void evaluate_samples();
  void evaluate_strands();
  Strand strand(int k) const;

  BlendingCurveObject made_from_;
  /// Parameters of the samples of interval [t_i, t_{i+1}], i = 1 .. : intervals_[i-1].
  std::vector<std::vector<double>> intervals_;
};

}  // namespace knotwork::scene
