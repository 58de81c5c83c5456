#pragma once

#include <vector>

#include "knotwork/curve/curve_fit.h"
#include "knotwork/scene/later.h"
#include "knotwork/scene/limits.h"
#include "knotwork/scene/objects.h"

namespace knotwork::scene {

/// What the object asks fit_curve() for.
CurveFitSettings fit_settings(const FittedCurveObject& object);

/// The curve that the object means. Errors are those of fit_curve(), with the object's members as paths.
KNOTWORK_LATER Result<CurveFit> build_fit(const FittedCurveObject& object);
KNOTWORK_LATER Status check_fit(const FittedCurveObject& object);

/// The object with a change, if that can be fitted; else its error, and the object as it was.
template <class Change>
Status refit(FittedCurveObject& object, Change change) {
  FittedCurveObject changed = object;
  change(changed);
  if (Status status = check_fit(changed); !status) return status;
  object = std::move(changed);
  return success();
}

/// Other data. Error path: `points`, `points[i]`, or what else keeps them from being fitted.
KNOTWORK_LATER Status set_points(FittedCurveObject& object, std::vector<Eigen::Vector3d> points);

/// How many control points the data may have.
KNOTWORK_LATER Limits control_point_range(const FittedCurveObject& object);

}  // namespace knotwork::scene
