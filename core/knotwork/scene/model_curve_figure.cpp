#include "knotwork/scene/model_curve_figure.h"

#include <array>
#include <cmath>

#include "knotwork/scene/curve_sampling.h"

namespace knotwork::scene {

namespace {

constexpr double smooth_tolerance = 1.5e-4;                     // of the size
constexpr double least_curvature = 1e-9, least_torsion = 1e-9;  // times the size: what is left of rounding is less

}  // namespace

ModelCurveFigure::ModelCurveFigure(const ModelCurveObject& object) : model(object.model) {
  sample();
  update(object);
}

void ModelCurveFigure::update(const ModelCurveObject& object) {
  if (!(object.model == model)) {
    model = object.model;
    sample();
  }
  t = std::lerp(start, end, object.parameter);
  std::array<Eigen::Vector3d, 4> jet;
  evaluate(model, t, jet);
  point = jet[0];
  frame = frenet_frame(jet, least_curvature / size);
  circle.reset();
  if (frame.regular && !frame.straight)
    circle = OsculatingCircle{point + frame.normal / frame.curvature, 1 / frame.curvature};
}

void ModelCurveFigure::sample() {
  const CurveView curve = view_of(model);
  start = curve.start;
  end = curve.end;
  topology = curve.topology;
  size = drawn_size(curve);
  samples.clear();
  curvatures.clear();
  torsions.clear();
  flat = true;
  for (const double at : drawing_parameters(curve, start, end, least_steps(model), smooth_tolerance * size)) {
    std::array<Eigen::Vector3d, 4> jet;
    curve.evaluate(at, jet);
    const FrenetFrame here = frenet_frame(jet, least_curvature / size);
    samples.push_back({at, jet[0]});
    curvatures.push_back(here.curvature);
    torsions.push_back(here.torsion);
    flat = flat && std::abs(here.torsion) <= least_torsion / size;
  }
}

}  // namespace knotwork::scene
