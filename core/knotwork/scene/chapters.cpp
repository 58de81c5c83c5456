#include "knotwork/scene/chapters.h"

#include <algorithm>
#include <numbers>

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

Document bezier_curve_start() {
  BezierCurveObject curve;
  curve.points = {{0, 0, 0}, {1, 3, 0}, {4.2, 3.6, 0}, {5.5, 0.4, 0}};
  curve.parameter = 0.4;
  return flat_start("curve", curve, {2.75, 1.8, 0});
}

/// The report's seven points under clamped, evenly spaced knots.
Document bspline_curve_start() {
  BSplineCurveObject curve;
  curve.degree = 3;
  curve.points = {{5, 2, 8}, {2, 9, 2}, {2, 3, 4}, {3, 4, 5}, {3, 6, 0}, {1, 4, 0}, {5, 8, 3}};
  curve.knots = {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4};
  curve.parameter = 0.4;
  Document document = flat_start("curve", curve, {3, 5.5, 4});
  document.camera.azimuth = -1.1;
  document.camera.elevation = 0.3;
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
  };
  return table;
}

const Chapter* find_chapter(std::string_view id) {
  const std::span<const Chapter> table = chapters();
  const auto found = std::find_if(table.begin(), table.end(), [&](const Chapter& row) { return row.id == id; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace knotwork::scene
