#include "web/camera.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "web/vectors.h"

namespace knotwork::web {
namespace {

using std::numbers::pi;
constexpr double least_free_share = 0.25;
constexpr double near_share = 0.02;  // of the distance
// The ground and patches dragged far out must not be cut off when the reader comes close to one spot.
constexpr double far_share = 20, far_least = 40;

/// Start and length of what two insets leave of a side.
glm::dvec2 free_stretch(double length, double before, double after) {
  before = std::max(before, 0.0);
  after = std::max(after, 0.0);
  const double most = (1 - least_free_share) * length;
  if (before + after > most) {
    const double shrink = most / (before + after);
    before *= shrink;
    after *= shrink;
  }
  return {before, length - before - after};
}

double shorter_side(const Viewport& viewport) {
  const FreeArea area = free_area(viewport);
  return std::min(area.size.x, area.size.y);
}

/// CSS pixels from the eye to the picture plane.
double focal_length(const Viewport& viewport) { return 0.5 * shorter_side(viewport) / std::tan(0.5 * field_of_view); }

/// The near plane's depth, as the projection holds it.
double near_plane(const glm::dmat4& projection) { return projection[3][2] / (projection[2][2] - 1); }

glm::dvec3 direction(const scene::Camera& camera) {
  const double c = std::cos(camera.elevation);
  return {c * std::cos(camera.azimuth), c * std::sin(camera.azimuth), std::sin(camera.elevation)};
}

double limited_distance(double distance, const scene::Camera& otherwise) {
  return std::clamp(distance, std::min(min_distance, otherwise.distance), std::max(max_distance, otherwise.distance));
}

scene::Camera limited(scene::Camera camera, const scene::Camera& otherwise) {
  const double numbers[] = {camera.target.x(), camera.target.y(), camera.target.z(),
                            camera.distance,   camera.azimuth,    camera.elevation};
  if (!std::all_of(std::begin(numbers), std::end(numbers), [](double x) { return std::isfinite(x); })) {
    return otherwise;
  }
  camera.target = camera.target.cwiseMax(-scene::max_coordinate).cwiseMin(scene::max_coordinate);
  camera.distance = limited_distance(camera.distance, otherwise);
  camera.azimuth = std::remainder(camera.azimuth, 2 * pi);
  const double steepest = std::max(max_elevation, std::abs(otherwise.elevation));
  camera.elevation = std::clamp(camera.elevation, -steepest, steepest);
  return camera;
}

}  // namespace

FreeArea free_area(const Viewport& viewport) {
  // A stage that is not laid out yet has no size; one pixel keeps every quotient finite.
  const glm::dvec2 x = free_stretch(std::max(viewport.width, 1.0), viewport.inset_left, viewport.inset_right);
  const glm::dvec2 y = free_stretch(std::max(viewport.height, 1.0), viewport.inset_top, viewport.inset_bottom);
  return {{x[0] + 0.5 * x[1], y[0] + 0.5 * y[1]}, {x[1], y[1]}};
}

View make_view(const scene::Camera& camera, const Viewport& viewport) {
  View view;
  view.viewport = viewport;
  view.viewport.width = std::max(viewport.width, 1.0);
  view.viewport.height = std::max(viewport.height, 1.0);

  const glm::dvec3 target = to_glm(camera.target);
  const glm::dvec3 outwards = direction(camera);
  view.eye = target + camera.distance * outwards;
  view.forward = -outwards;
  // From the azimuth, not from a cross product with z, which loses digits near the poles.
  view.right = {-std::sin(camera.azimuth), std::cos(camera.azimuth), 0};
  view.up = glm::cross(view.right, view.forward);
  view.view = glm::lookAt(view.eye, target, view.up);

  const glm::dvec2 centre = free_area(viewport).centre;
  const double near = near_share * camera.distance;
  const double far = far_share * camera.distance + far_least;
  const double share = near / focal_length(viewport);  // model units on the near plane that one CSS pixel covers
  view.projection = glm::frustum(-share * centre.x, share * (view.viewport.width - centre.x),
                                 -share * (view.viewport.height - centre.y), share * centre.y, near, far);
  return view;
}

std::optional<glm::dvec3> View::project(glm::dvec3 point) const {
  // Relative to the eye first: the view matrix's translation would cancel digits far from the origin.
  const glm::dvec3 d = point - eye;
  const glm::dvec4 clip = projection * glm::dvec4(glm::dot(d, right), glm::dot(d, up), -glm::dot(d, forward), 1);
  // Beside the eye rounding decides the sign, and a place would be light years off the screen.
  if (clip.w < 1e-3 * near_plane(projection)) return std::nullopt;
  return glm::dvec3(0.5 * viewport.width * (1 + clip.x / clip.w), 0.5 * viewport.height * (1 - clip.y / clip.w),
                    clip.w);
}

scene::Ray View::ray(glm::dvec2 screen) const {
  const double x = (2 * screen.x / viewport.width - 1 + projection[2][0]) / projection[0][0];
  const double y = (1 - 2 * screen.y / viewport.height + projection[2][1]) / projection[1][1];
  return {to_eigen(eye), to_eigen(glm::normalize(forward + x * right + y * up))};
}

double View::pixel_size(glm::dvec3 point) const {
  const double focal = 0.5 * viewport.height * projection[1][1];
  return std::max(glm::dot(point - eye, forward), near_plane(projection)) / focal;
}

scene::Camera orbit(const scene::Camera& camera, glm::dvec2 pixels, const Viewport& viewport) {
  const double rate = pi / shorter_side(viewport);
  scene::Camera turned = camera;
  turned.azimuth -= rate * pixels.x;
  turned.elevation += rate * pixels.y;
  return limited(turned, camera);
}

scene::Camera pan(const scene::Camera& camera, glm::dvec2 pixels, const View& view) {
  return pan(camera, pixels, view, to_glm(camera.target));
}

scene::Camera pan(const scene::Camera& camera, glm::dvec2 pixels, const View& view, glm::dvec3 point) {
  const double size = view.pixel_size(point);
  scene::Camera moved = camera;
  moved.target += to_eigen(size * (pixels.y * view.up - pixels.x * view.right));
  return limited(moved, camera);
}

scene::Camera zoom(const scene::Camera& camera, double factor, glm::dvec2 anchor, const View& view) {
  const glm::dvec2 offset = anchor - free_area(view.viewport).centre;
  const double size = view.pixel_size(to_glm(camera.target));
  return zoom(camera, factor, to_glm(camera.target) + size * (offset.x * view.right - offset.y * view.up));
}

scene::Camera zoom(const scene::Camera& camera, double factor, glm::dvec3 around) {
  if (!std::isfinite(factor) || factor <= 0) return camera;
  scene::Camera zoomed = camera;
  zoomed.distance = limited_distance(camera.distance / factor, camera);
  zoomed.target += (1 - zoomed.distance / camera.distance) * (to_eigen(around) - camera.target);
  return limited(zoomed, camera);
}

double ease(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * t * (t * (6 * t - 15) + 10);
}

scene::Camera between(const scene::Camera& from, const scene::Camera& to, double share) {
  if (share <= 0) return from;
  if (share >= 1) return to;
  const double s = ease(share);
  scene::Camera camera;
  camera.target = (1 - s) * from.target + s * to.target;
  camera.distance = from.distance * std::pow(to.distance / from.distance, s);
  camera.azimuth = std::remainder(from.azimuth + s * std::remainder(to.azimuth - from.azimuth, 2 * pi), 2 * pi);
  camera.elevation = (1 - s) * from.elevation + s * to.elevation;
  return camera;
}

}  // namespace knotwork::web
