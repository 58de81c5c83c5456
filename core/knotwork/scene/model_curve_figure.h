#pragma once

#include <optional>
#include <vector>

#include "knotwork/curve/curve_measures.h"
#include "knotwork/scene/curve_sample.h"
#include "knotwork/scene/objects.h"

namespace knotwork::scene {

/// What stands on the stage of a model curve: everything that is drawn of it or read off.
struct ModelCurveFigure {
  /// Precondition: the object is valid.
  explicit ModelCurveFigure(const ModelCurveObject& object);
  /// The same for a changed object; keeps the samples where only the parameter is another.
  void update(const ModelCurveObject& object);

  struct OsculatingCircle {
    Eigen::Vector3d centre;
    double radius;  ///< model units
  };

  CatalogueCurve model;
  Topology topology = Topology::open;
  double start = 0, end = 1;
  double size = 1;   ///< half the diagonal of the curve's box
  bool flat = true;  ///< without torsion: nothing to plot
  /// Ascending, close enough for a smooth picture; the curvatures and torsions there.
  std::vector<CurveSample> samples;
  std::vector<double> curvatures, torsions;

  double t = 0;  ///< where the frame is
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  FrenetFrame frame;
  std::optional<OsculatingCircle> circle;  ///< none where the curve is straight or stands still

 private:
  void sample();
};

}  // namespace knotwork::scene
