#pragma once

#include <vector>

#include <Eigen/Core>

#include "knotwork/curve/curve_fit.h"
#include "knotwork/scene/curve_figure.h"
#include "knotwork/scene/objects.h"

namespace knotwork::scene {

/// What stands on the stage of a fitted curve: everything that is drawn of it, held or read off.
struct FitFigure {
  /// The errors are compared for n up to so many.
  static constexpr int most_compared = 60;

  /// Precondition: the object is valid. `before`, if given, lends its comparison where only n has changed: that is the
  /// costly part, about fifty fits.
  explicit FitFigure(const FittedCurveObject& object, const FitFigure* before = nullptr);

  CurveFigure curve;
  std::vector<Eigen::Vector3d> points;  ///< the data p_j
  int degree, count;                    ///< p and n
  double rms, maximum;                  ///< model units
  std::vector<double> residuals;        ///< r_j = |c(x_j) - p_j|
  std::vector<double> parameters;       ///< x_j
  std::vector<Eigen::Vector3d> feet;    ///< c(x_j): where the whisker of point j ends
  std::vector<CurveFitError> errors;    ///< for n from the least to min(m, most_compared), as far as there are fits

 private:
  FitFigure(const FittedCurveObject& object, CurveFit fit, const FitFigure* before);

  FittedCurveObject compared_;  ///< what `errors` belongs to, but for n
};

}  // namespace knotwork::scene
