#include "knotwork/scene/surface_builder.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "knotwork/surface/surface_measures.h"

namespace knotwork::scene {

namespace {

/// Below this share of the way a rolling direction counts as open: the last interval would be too narrow for its knots.
constexpr double smallest_roll = 1e-6;

/// One direction on the way between its topologies.
struct Direction {
  Topology topology;  ///< of the knots: closed only when the roll is complete
  int count;          ///< n, the ghost not counted
  bool ghost;
  double roll;

  int rows() const { return count + (ghost ? 1 : 0); }
};

Direction direction(int count, double roll) {
  if (roll >= 1) return {Topology::closed, count, false, 1};
  if (roll < smallest_roll) return {Topology::open, count, false, 0};
  return {Topology::open, count, true, roll};
}

/// Centres every h from the start, and with a ghost one more at the end, roll * h after the last.
KnotVector knots(const Direction& d, const Interval& range) {
  if (!d.ghost) return KnotVector::uniform(1, d.count, d.topology, range.start, range.end).value();
  const double h = (range.end - range.start) / (d.count - 1 + d.roll);
  std::vector<double> knots{range.start};
  for (int k = 0; k < d.count; ++k) knots.push_back(range.start + k * h);
  knots.push_back(range.end);
  knots.push_back(range.end);
  return KnotVector::make(1, Topology::open, std::move(knots)).value();
}

ModelSurface rolled(const ModelSurface& model, const Direction& u, const Direction& v) {
  ModelSurface result = model;
  if (Sheet* sheet = std::get_if<Sheet>(&result)) {
    sheet->bend_u = u.roll;
    sheet->bend_v = v.roll;
  }
  return result;
}

/// What moves a patch away from where the model has it: a reader's edit and the animation.
struct Pose {
  PatchEdit edit;
  PatchMotion motion;
};

/// Motions alternate like the fields of a chessboard.
using Motions = std::array<PatchMotion, 2>;
Motions motions(const Animation& animation) {
  return {patch_motion(animation, {0, 0}), patch_motion(animation, {0, 1})};
}

Pose pose(const BlendingSurfaceObject& object, const Motions& motions, PatchIndex patch) {
  const auto found = object.edits.find(patch);
  return {found == object.edits.end() ? PatchEdit{} : found->second,
          motions[static_cast<std::size_t>((patch.first + patch.second) % 2)]};
}

Eigen::Vector3d mixed(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double share) {
  return (1 - share) * a + share * b;
}

Pose mixed(const Pose& a, const Pose& b, double share) {
  Pose result;
  result.edit.translation = mixed(a.edit.translation, b.edit.translation, share);
  result.edit.rotation = a.edit.rotation.slerp(share, b.edit.rotation);
  result.edit.scale = mixed(a.edit.scale, b.edit.scale, share);
  result.motion.own_translation = mixed(a.motion.own_translation, b.motion.own_translation, share);
  result.motion.model_translation = mixed(a.motion.model_translation, b.motion.model_translation, share);
  result.motion.own_rotation = a.motion.own_rotation.slerp(share, b.motion.own_rotation);
  result.motion.model_rotation = a.motion.model_rotation.slerp(share, b.motion.model_rotation);
  return result;
}

DirectionSummary summary(const KnotVector& knots) {
  const int first = knots.degree(), last = knots.last_span() + 1;
  return {knots.topology(),       knots.start(), knots.end(), first, last, {knots.knots().begin(), knots.knots().end()},
          knots.interval_count(), knots.count()};
}

}  // namespace

Eigen::Matrix3d tangent_frame(const SurfaceJet& jet) {
  const Eigen::Vector3d normal = unit_normal(jet);
  Eigen::Vector3d x = jet.su - normal.dot(jet.su) * normal;
  if (x.norm() <= 1e-12 * (jet.su.norm() + jet.sv.norm())) x = normal.unitOrthogonal();
  x.normalize();
  Eigen::Matrix3d result;
  result << x, normal.cross(x), normal;
  return result;
}

Roll rest_roll(const BlendingSurfaceObject& object) {
  return {object.topology_u == Topology::closed ? 1.0 : 0.0, object.topology_v == Topology::closed ? 1.0 : 0.0};
}

BlendingSurface build_surface(const BlendingSurfaceObject& object, const Animation& animation) {
  return build_surface(object, animation, rest_roll(object));
}

BlendingSurface build_surface(const BlendingSurfaceObject& object, const Animation& animation, Roll roll) {
  const Direction u = direction(object.locals_u, roll.u), v = direction(object.locals_v, roll.v);
  const ModelSurface model = rolled(object.model, u, v);
  const SurfaceDomain where = domain(model);
  const KnotVector knots_u = knots(u, where.u), knots_v = knots(v, where.v);
  const int parameter = blending_family(object.blending).parameter_max > 0 ? object.blending_parameter : 0;
  Result<BlendingSurface> surface =
      BlendingSurface::make(model, knots_u, knots_v, BlendingFunction::make(object.blending, parameter).value(),
                            BlendingSurface::unmoved_locals(model, knots_u, knots_v), object.patches);
  update_locals(surface.value(), object, animation, roll, patch_frames(surface.value()));
  return std::move(surface).value();
}

void update_locals(BlendingSurface& surface, const BlendingSurfaceObject& object, const Animation& animation, Roll roll,
                   std::span<const Eigen::Matrix3d> axes) {
  const Direction u = direction(object.locals_u, roll.u), v = direction(object.locals_v, roll.v);
  assert(surface.knots_u().count() == u.rows() && surface.knots_v().count() == v.rows());

  const Motions clock = motions(animation);
  const auto pose_in_row = [&](int i, int j) {
    if (j < v.count) return pose(object, clock, {i, j});
    return mixed(pose(object, clock, {i, v.count - 1}), pose(object, clock, {i, 0}), v.roll);
  };
  for (int i = 0; i < u.rows(); ++i) {
    for (int j = 0; j < v.rows(); ++j) {
      const Pose here = i < u.count ? pose_in_row(i, j) : mixed(pose_in_row(u.count - 1, j), pose_in_row(0, j), u.roll);
      const Eigen::Matrix3d& own = axes[static_cast<std::size_t>(i * v.rows() + j)];
      surface.set_local(i, j, local_map({surface.centre_jet(i, j).s, own, here.edit, here.motion}));
    }
  }
}

LocalFrame local_frame(const BlendingSurfaceObject& object, const Animation& animation, const BlendingSurface& surface,
                       PatchIndex patch) {
  const SurfaceJet& centre = surface.centre_jet(patch.first, patch.second);
  const Pose here = pose(object, motions(animation), patch);
  return {centre.s, tangent_frame(centre), here.edit, here.motion};
}

Eigen::Matrix3d patch_frame(const BlendingSurface& surface, PatchIndex patch) {
  return tangent_frame(surface.centre_jet(patch.first, patch.second));
}

std::vector<Eigen::Matrix3d> patch_frames(const BlendingSurface& surface) {
  std::vector<Eigen::Matrix3d> axes;
  axes.reserve(static_cast<std::size_t>(surface.knots_u().count() * surface.knots_v().count()));
  for (int i = 0; i < surface.knots_u().count(); ++i) {
    for (int j = 0; j < surface.knots_v().count(); ++j) axes.push_back(patch_frame(surface, {i, j}));
  }
  return axes;
}

Eigen::Vector3d patch_origin(const BlendingSurface& surface, PatchIndex patch) {
  return surface.local(patch.first, patch.second).translation();
}

DirectionSummary summary_u(const BlendingSurface& surface) { return summary(surface.knots_u()); }
DirectionSummary summary_v(const BlendingSurface& surface) { return summary(surface.knots_v()); }

}  // namespace knotwork::scene
