#include "knotwork/scene/fit_figure.h"

#include <algorithm>
#include <utility>

#include "knotwork/scene/fit_edits.h"

namespace knotwork::scene {

namespace {

FittedCurveObject without_count(FittedCurveObject object) {
  object.count = 0;
  return object;
}

}  // namespace

FitFigure::FitFigure(const FittedCurveObject& object, const FitFigure* before)
    : FitFigure(object, build_fit(object).value(), before) {}

FitFigure::FitFigure(const FittedCurveObject& object, CurveFit fit, const FitFigure* before)
    : curve(std::move(fit.fit.curve), 0),
      points(object.points),
      degree(object.degree),
      count(object.count),
      rms(fit.fit.rms),
      maximum(fit.fit.maximum),
      residuals(std::move(fit.fit.residuals)),
      parameters(std::move(fit.parameters)),
      feet(object.points.size()),
      compared_(without_count(object)) {
  curve.curve.evaluate(parameters, 0, feet);
  if (before != nullptr && before->compared_ == compared_) {
    errors = before->errors;
  } else {
    const int most = std::min(static_cast<int>(object.points.size()), most_compared);
    errors = fit_errors(object.points, fit_settings(object), most);
  }
}

}  // namespace knotwork::scene
