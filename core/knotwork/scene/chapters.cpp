#include "knotwork/scene/chapters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "knotwork/scene/later.h"
#include "knotwork/scene/net_roll.h"

namespace knotwork::scene {

namespace {

/// A torus of 6 x 4 patches, one on the outer equator pulled outwards and turned a little, as one sees it when the
/// page opens: at the left, towards the reader.
Document blending_surface_start() {
  BlendingSurfaceObject surface;
  PatchEdit pulled;
  pulled.translation = {0, 0, 0.55};
  pulled.rotation = Eigen::AngleAxisd(0.3, Eigen::Vector3d(0.6, 0, 0.8));
  // Local (2, 2) is centred at u = -pi/3, v = 0 of the sheet.
  surface.edits[{2, 2}] = pulled;

  Document document;
  document.objects.push_back({"surface", "Blending surface", surface});
  document.camera.target = {0, 0, 0};
  document.camera.distance = 5.2;
  document.camera.azimuth = 0.2;
  document.camera.elevation = 0.55;
  return document;
}

/// A flat figure seen from above, y upwards.
Document flat_start(std::string id, Shape shape, const Eigen::Vector3d& middle) {
  Document document;
  document.objects.push_back({std::move(id), std::string(shape_kinds()[shape.index()].label), std::move(shape)});
  document.camera.target = middle;
  document.camera.distance = 16;
  document.camera.azimuth = -std::numbers::pi / 2;
  document.camera.elevation = 1.5533;
  return document;
}

KNOTWORK_LATER Document bezier_curve_start() {
  BezierCurveObject curve;
  curve.points = {{0, 0, 0}, {1, 3, 0}, {4.2, 3.6, 0}, {5.5, 0.4, 0}};
  curve.parameter = 0.4;
  return flat_start("curve", curve, {2.75, 1.8, 0});
}

std::vector<Eigen::Vector3d> report_points() {
  return {{5, 2, 8}, {2, 9, 2}, {2, 3, 4}, {3, 4, 5}, {3, 6, 0}, {1, 4, 0}, {5, 8, 3}};
}

/// The report's seven points under clamped, evenly spaced knots.
KNOTWORK_LATER Document bspline_curve_start() {
  BSplineCurveObject curve;
  curve.degree = 3;
  curve.points = report_points();
  curve.knots = {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4};
  curve.parameter = 0.4;
  Document document = flat_start("curve", curve, {3, 5.5, 4});
  document.camera.azimuth = -1.1;
  document.camera.elevation = 0.3;
  return document;
}

/// Points of a circle of radius 5, `steps` to a turn.
std::vector<Eigen::Vector3d> circle_points(int count, int steps) {
  std::vector<Eigen::Vector3d> points;
  for (int j = 0; j < count; ++j) {
    const double angle = 2 * std::numbers::pi * (j % steps) / steps;
    points.emplace_back(5 * std::cos(angle), 5 * std::sin(angle), 0);
  }
  return points;
}

/// A fit of the circle by 8 control points.
Document circle_fit_start(Topology topology, int steps) {
  FittedCurveObject curve;
  curve.points = circle_points(20, steps);
  curve.degree = 3;
  curve.count = 8;
  curve.topology = topology;
  Document document = flat_start("fit", curve, {0, 0, 0});
  document.camera.distance = 30;
  return document;
}

/// The report's experiment: an open curve near 20 points of which the last is the first again.
KNOTWORK_LATER Document least_squares_start() { return circle_fit_start(Topology::open, 19); }

/// The experiment put right: a closed curve near 20 points, none of them twice.
KNOTWORK_LATER Document closed_least_squares_start() { return circle_fit_start(Topology::closed, 20); }

/// The report's seven points as a closed polygon, one level done of four.
KNOTWORK_LATER Document subdivision_start() {
  SubdivisionCurveObject curve;
  curve.degree = 3;
  curve.topology = Topology::closed;
  curve.points = report_points();
  curve.levels = 4;
  curve.step = 4;
  Document document = flat_start("polygon", curve, {3, 5.5, 4});
  document.camera.azimuth = -1.1;
  document.camera.elevation = 0.3;
  return document;
}

/// A torus knot with its frame and its osculating circle.
KNOTWORK_LATER Document model_curve_start() {
  ModelCurveObject curve;
  curve.model = make_catalogue_curve("torus-knot").value();
  curve.parameter = 0.08;
  Document document = flat_start("curve", curve, {0, 0, 0});
  document.camera.distance = 6;
  document.camera.azimuth = -1.2;
  document.camera.elevation = 0.75;
  document.display.frames = true;
  return document;
}

/// The report's model curve and motion; one of ten locals is moved and turned a little, so that the picture teaches at
/// rest.
KNOTWORK_LATER Document blending_curve_start() {
  BlendingCurveObject curve;
  PatchEdit pulled;
  pulled.translation = {0, 0, 0.45};
  pulled.rotation = Eigen::AngleAxisd(0.5, Eigen::Vector3d(0.6, 0, 0.8));
  curve.edits[{5, 0}] = pulled;  // on the left, outwards
  curve.parameter = 0.545;
  Document document = flat_start("curve", curve, {0, 0, 0});
  document.camera.distance = 7;
  document.camera.azimuth = -1.2;
  document.camera.elevation = 0.8;
  document.display.local_patches = true;
  document.animation.motion = MotionKind::report;
  document.animation.amplitude = 0.25;
  document.animation.rotation = 1;
  return document;
}

/// A bicubic sheet of 6 x 5 control points, upright before the reader, one point pulled out of it.
KNOTWORK_LATER Document tensor_surface_start() {
  BSplineSurfaceObject surface;
  surface.u = {3, Topology::open, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}};
  surface.v = {3, Topology::open, {0, 0, 0, 0, 1, 2, 2, 2, 2}};
  surface.net.assign(6, std::vector<Eigen::Vector3d>(5));
  surface.net = net_on_sheet(surface);
  surface.net[3][2].x() += 1.6;

  Document document;
  document.objects.push_back({"surface", "B-spline surface", surface});
  document.camera.distance = 6.5;
  document.camera.azimuth = 0.95;
  document.camera.elevation = 0.3;
  return document;
}

/// Boy's surface: one-sided, and it crosses itself.
KNOTWORK_LATER Document model_surface_start() {
  ModelSurfaceObject surface;
  for (const ModelRow& row : model_kinds())
    if (row.id == "boy") surface.model = make_model(row.kind);

  Document document;
  document.objects.push_back({"surface", "Model surface", surface});
  document.camera.distance = 5;
  document.camera.azimuth = 0.7;
  document.camera.elevation = 0.4;
  return document;
}

}  // namespace

std::span<const Chapter> chapters() {
  static const std::vector<Chapter> table{
      {"blending-surface",
       "Blending surfaces",
       blending_surface_start,
       {"topology.u", "topology.v", "locals.u", "locals.v", "blending.function", "animation.playing"}},
      {"bezier-curve", "Bézier curves", bezier_curve_start, {"curve.parameter"}},
      {"bspline-curve", "B-spline curves", bspline_curve_start, {"curve.degree", "curve.topology", "curve.parameter"}},
      {"least-squares",
       "Least squares",
       least_squares_start,
       {"fitted.count", "curve.degree", "curve.topology", "fitted.parameters"}},
      {"least-squares-closed",
       "Least squares, closed",
       closed_least_squares_start,
       {"fitted.count", "curve.degree", "fitted.parameters"}},
      {"subdivision",
       "Subdivision",
       subdivision_start,
       {"curve.degree", "curve.topology", "subdivision.levels", "subdivision.step", "animation.playing"}},
      {"model-curve", "Model curves", model_curve_start, {"curve.model", "curve.parameter"}},
      {"blending-curve",
       "Blending curves",
       blending_curve_start,
       {"curve.topology", "locals.count", "locals.kind", "blending.function", "animation.playing"}},
      {"tensor-surface",
       "Tensor-product surfaces",
       tensor_surface_start,
       {"topology.u", "topology.v", "surface.degree.u", "surface.degree.v", "net.u", "net.v"}},
      {"model-surface", "Model surfaces", model_surface_start, {"model", "samples.u", "samples.v"}},
  };
  return table;
}

const Chapter* find_chapter(std::string_view id) {
  const std::span<const Chapter> table = chapters();
  const auto found = std::find_if(table.begin(), table.end(), [&](const Chapter& row) { return row.id == id; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace knotwork::scene
