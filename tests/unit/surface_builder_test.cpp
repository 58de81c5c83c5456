#include "knotwork/scene/surface_builder.h"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "knotwork/scene/motion.h"
#include "knotwork/surface/surface_measures.h"

namespace knotwork::scene::surface_builder_test {
namespace {

using std::numbers::pi;

PatchEdit some_edit(double x, double y, double z) {
  PatchEdit edit;
  edit.translation = {x, y, z};
  edit.rotation = Eigen::AngleAxisd(0.5 + x, Eigen::Vector3d(1, 2, 2) / 3);
  edit.scale = {1.2, 0.9, 1 + y};
  return edit;
}

/// Edits on a first, a last and an inner patch of each direction.
BlendingSurfaceObject edited(const ModelSurface& model, Topology u, Topology v) {
  BlendingSurfaceObject object;
  object.model = model;
  object.topology_u = u;
  object.topology_v = v;
  object.locals_u = 5;
  object.locals_v = 4;
  object.edits[{0, 1}] = some_edit(0.1, 0.2, 0.3);
  object.edits[{4, 1}] = some_edit(-0.1, 0.1, 0.2);
  object.edits[{2, 0}] = some_edit(0.2, -0.1, -0.1);
  object.edits[{2, 3}] = some_edit(0, 0.1, 0.4);
  object.edits[{0, 0}] = some_edit(0.1, 0, -0.2);
  return object;
}

Animation moving(MotionKind kind) {
  Animation animation;
  animation.motion = kind;
  animation.time = 1.1;
  animation.rotation = 1;
  return animation;
}

/// The largest distance of two surfaces over the same domain, ends included.
double sup_distance(const BlendingSurface& a, const BlendingSurface& b) {
  const auto at = [](const KnotVector& knots, double share) {
    return share == 1 ? knots.end() : knots.start() + share * knots.period();
  };
  const int steps = 31;
  double largest = 0;
  for (int k = 0; k <= steps; ++k) {
    for (int l = 0; l <= steps; ++l) {
      const double s = static_cast<double>(k) / steps, t = static_cast<double>(l) / steps;
      const Eigen::Vector3d p = a.evaluate(at(a.knots_u(), s), at(a.knots_v(), t)).s;
      const Eigen::Vector3d q = b.evaluate(at(b.knots_u(), s), at(b.knots_v(), t)).s;
      largest = std::max(largest, (p - q).norm());
    }
  }
  return largest;
}

/// That the surface at roll(epsilon) comes to `rest` in proportion to epsilon.
template <class F>
void check_limit(const BlendingSurfaceObject& object, const Animation& animation, const BlendingSurface& rest, F roll) {
  const auto distance = [&](double epsilon) {
    return sup_distance(build_surface(object, animation, roll(epsilon)), rest);
  };
  const double coarse = distance(1e-3), fine = distance(1e-4), finest = distance(1e-5);
  CHECK(coarse < 0.05);
  CHECK(fine <= 0.13 * coarse);
  CHECK(finest <= 0.13 * fine);
  CHECK(finest < 2e-4);
}

}  // namespace

TEST_CASE("surface builder: unmoved locals are translations exactly, so the surface is the model") {
  for (const ModelRow& row : model_kinds()) {
    const ModelKind kind = row.kind;
    CAPTURE(row.id);
    BlendingSurfaceObject object;
    object.model = make_model(kind);
    if (!closes_u(object.model)) object.topology_u = Topology::open;
    if (!closes_v(object.model)) object.topology_v = Topology::open;
    const BlendingSurface surface = build_surface(object, Animation{});
    int exact = 0;
    for (int i = 0; i < object.locals_u; ++i) {
      for (int j = 0; j < object.locals_v; ++j) {
        const Eigen::Vector2d c = surface.centre(i, j);
        const Eigen::Affine3d& map = surface.local(i, j);
        if (map.linear() == Eigen::Matrix3d::Identity() &&
            map.translation() == evaluate(surface.model(), c.x(), c.y()).s) {
          ++exact;
        }
      }
    }
    CHECK(exact == object.locals_u * object.locals_v);
    const SurfaceDomain where = domain(surface.model());
    const double u = where.u.start + 0.3 * (where.u.end - where.u.start);
    const double v = where.v.start + 0.8 * (where.v.end - where.v.start);
    CHECK((surface.evaluate(u, v).s - evaluate(surface.model(), u, v).s).norm() <
          1e-14 * (1 + surface.centre(1, 1).norm()));
  }
}

TEST_CASE("surface builder: M_ij is the edit's formula in the patch's frame") {
  const BlendingSurfaceObject object = edited(Sheet{}, Topology::closed, Topology::closed);
  const BlendingSurface surface = build_surface(object, Animation{});
  for (const auto& [patch, edit] : object.edits) {
    const Eigen::Matrix3d f = patch_frame(surface, patch);
    CHECK((f.transpose() * f - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    CHECK(f.determinant() == doctest::Approx(1));
    const Eigen::Vector2d c = surface.centre(patch.first, patch.second);
    const SurfaceJet jet = evaluate(surface.model(), c.x(), c.y());
    CHECK((f.col(0) - jet.su.normalized()).norm() < 1e-14);
    CHECK((f.col(2) - unit_normal(jet)).norm() < 1e-14);

    const Eigen::Affine3d& map = surface.local(patch.first, patch.second);
    CHECK((map.translation() - (jet.s + f * edit.translation)).norm() < 1e-14);
    const Eigen::Matrix3d linear = f * edit.rotation.toRotationMatrix() * edit.scale.asDiagonal() * f.transpose();
    CHECK((map.linear() - linear).norm() < 1e-13);
    CHECK((patch_origin(surface, patch) - map.translation()).norm() == 0);
  }
}

TEST_CASE("surface builder: an edit moves the surface on the patch's support and nowhere else") {
  BlendingSurfaceObject object;
  const BlendingSurface before = build_surface(object, Animation{});
  object.edits[{2, 2}].translation = {0, 0, 0.55};
  const BlendingSurface after = build_surface(object, Animation{});
  const Eigen::Vector2d centre = before.centre(2, 2);
  const double width_u = 2 * pi / 6, width_v = 2 * pi / 4;
  int outside = 0, inside = 0;
  for (double u = -pi; u < pi; u += 0.1) {
    for (double v = -pi; v < pi; v += 0.1) {
      const double moved = (after.evaluate(u, v).s - before.evaluate(u, v).s).norm();
      const bool on_support = std::abs(u - centre.x()) < width_u && std::abs(v - centre.y()) < width_v;
      if (!on_support && moved != 0) ++outside;
      if (on_support && moved > 0) ++inside;
    }
  }
  CHECK(outside == 0);
  CHECK(inside > 400);
  CHECK((after.evaluate(centre.x(), centre.y()).s - before.evaluate(centre.x(), centre.y()).s).norm() ==
        doctest::Approx(0.55));
}

TEST_CASE("surface builder: edits beyond the counts sleep and wake again") {
  BlendingSurfaceObject object = edited(Sheet{}, Topology::closed, Topology::closed);
  BlendingSurfaceObject few = object;
  few.locals_u = 2;
  few.locals_v = 2;
  const BlendingSurface surface = build_surface(few, Animation{});
  CHECK(surface.knots_u().count() == 2);
  CHECK(surface.local(1, 1).linear() == Eigen::Matrix3d::Identity());
  few.locals_u = object.locals_u;
  few.locals_v = object.locals_v;
  CHECK(sup_distance(build_surface(few, Animation{}), build_surface(object, Animation{})) == 0);
}

TEST_CASE("surface builder: a rolling direction meets both topologies without a jump, first order in what is left") {
  const Topology open = Topology::open, closed = Topology::closed;
  for (const Animation& animation : {Animation{}, moving(MotionKind::breathe), moving(MotionKind::report)}) {
    for (const ModelSurface& model : {ModelSurface(Sheet{}), ModelSurface(torus_surface())}) {
      for (Topology other : {open, closed}) {
        const double rest = other == closed ? 1 : 0;
        const BlendingSurfaceObject in_u = edited(model, closed, other), in_v = edited(model, other, closed);
        check_limit(in_u, animation, build_surface(in_u, animation, {1, rest}), [&](double e) {
          return Roll{1 - e, rest};
        });
        check_limit(in_u, animation, build_surface(in_u, animation, {0, rest}), [&](double e) {
          return Roll{e, rest};
        });
        check_limit(in_v, animation, build_surface(in_v, animation, {rest, 1}), [&](double e) {
          return Roll{rest, 1 - e};
        });
        check_limit(in_v, animation, build_surface(in_v, animation, {rest, 0}), [&](double e) {
          return Roll{rest, e};
        });
      }
    }
  }
}

TEST_CASE("surface builder: both directions may roll at once") {
  const BlendingSurfaceObject object = edited(Sheet{}, Topology::closed, Topology::closed);
  check_limit(object, Animation{}, build_surface(object, Animation{}, {1, 1}), [](double e) {
    return Roll{1 - e, 1 - e};
  });
  check_limit(object, Animation{}, build_surface(object, Animation{}, {0, 0}), [](double e) { return Roll{e, e}; });
  const BlendingSurface half = build_surface(object, Animation{}, {0.5, 0.25});
  CHECK(half.knots_u().count() == 6);
  CHECK(half.knots_v().count() == 5);
  CHECK_FALSE(half.knots_u().closed());
  CHECK(sup_distance(half, build_surface(object, Animation{}, {0.5, 0.2501})) < 1e-3);
}

TEST_CASE("surface builder: the ghost stands between the last local and the first") {
  const BlendingSurfaceObject object = edited(torus_surface(), Topology::open, Topology::closed);
  const BlendingSurface surface = build_surface(object, Animation{}, {0.25, 1});
  // Knots every h, the last interval a quarter as wide.
  const KnotVector& knots = surface.knots_u();
  CHECK(knots.count() == 6);
  const double h = knots[2] - knots[1];
  CHECK(knots[5] - knots[4] == doctest::Approx(h));
  CHECK(knots[6] - knots[5] == doctest::Approx(h / 4));
  const Eigen::Vector3d expected =
      0.75 * object.edits.at({4, 1}).translation + 0.25 * object.edits.at({0, 1}).translation;
  const Eigen::Vector2d c = surface.centre(5, 1);
  const Eigen::Vector3d centre = evaluate(surface.model(), c.x(), c.y()).s;
  const Eigen::Matrix3d f = patch_frame(surface, {5, 1});
  CHECK((f.transpose() * (patch_origin(surface, {5, 1}) - centre) - expected).norm() < 1e-13);
}

TEST_CASE("surface builder: the ends of a roll are the resting surfaces themselves") {
  const BlendingSurfaceObject object = edited(Sheet{}, Topology::closed, Topology::open);
  const Roll rest = rest_roll(object);
  CHECK(rest.u == 1);
  CHECK(rest.v == 0);
  const BlendingSurface surface = build_surface(object, Animation{});
  CHECK(sup_distance(surface, build_surface(object, Animation{}, rest)) == 0);
  // Too small a rest to roll counts as open; the other end may be as near as doubles allow.
  CHECK(build_surface(object, Animation{}, {1, 1e-9}).knots_v().count() == object.locals_v);
  CHECK(build_surface(object, Animation{}, {std::nextafter(1.0, 0.0), 0}).knots_u().count() == object.locals_u + 1);
  CHECK(build_surface(object, Animation{}, {1, 1e-6}).knots_v().count() == object.locals_v + 1);
  BlendingSurfaceObject large = object;
  large.locals_v = max_locals;
  CHECK(build_surface(large, Animation{}, {1, 1e-6}).knots_v().count() == max_locals + 1);
}

TEST_CASE("surface builder: updating the locals is building anew") {
  BlendingSurfaceObject object = edited(Sheet{}, Topology::closed, Topology::closed);
  for (Roll roll : {Roll{1, 1}, Roll{0.3, 1}, Roll{0, 0.7}}) {
    BlendingSurface surface = build_surface(object, Animation{}, roll);
    for (MotionKind kind : {MotionKind::breathe, MotionKind::report}) {
      object.edits[{1, 1}].translation.z() += 0.1;
      update_locals(surface, object, moving(kind), roll, patch_frames(surface));
      CHECK(sup_distance(surface, build_surface(object, moving(kind), roll)) == 0);
    }
  }
}

TEST_CASE("surface builder: motion adds to the edit as its axes say") {
  BlendingSurfaceObject object;
  const BlendingSurface rest = build_surface(object, Animation{});
  const Animation report = moving(MotionKind::report);
  const BlendingSurface surface = build_surface(object, report);
  const PatchMotion motion = patch_motion(report, {1, 2});
  CHECK((patch_origin(surface, {1, 2}) - patch_origin(rest, {1, 2}) - motion.model_translation).norm() < 1e-14);
  CHECK((surface.local(1, 2).linear() - motion.model_rotation.toRotationMatrix()).norm() < 1e-14);

  object.edits[{1, 2}] = some_edit(0.1, 0.2, 0.3);
  const Eigen::Affine3d still = build_surface(object, Animation{}).local(1, 2);
  const Eigen::Affine3d turning = build_surface(object, report).local(1, 2);
  CHECK((turning.linear() - still.linear() * motion.model_rotation.toRotationMatrix()).norm() < 1e-14);

  const Animation breathing = moving(MotionKind::breathe);
  const PatchMotion own = patch_motion(breathing, {1, 2});
  const BlendingSurface breath = build_surface(object, breathing);
  const Eigen::Matrix3d f = patch_frame(breath, {1, 2});
  CHECK((breath.local(1, 2).translation() - still.translation() - f * own.own_translation).norm() < 1e-14);
}

TEST_CASE("surface builder: a frame exists where S_u vanishes") {
  BlendingSurfaceObject object;
  // The inner equator of this torus shrinks to the axis: |S_u| = 0 at v = pi.
  object.model = torus_surface(0.4, 0.4, 0.4);
  object.edits[{0, 2}].translation = {0, 0, 0.1};
  const BlendingSurface surface = build_surface(object, Animation{});
  const Eigen::Matrix3d f = patch_frame(surface, {0, 2});
  CHECK((f.transpose() * f - Eigen::Matrix3d::Identity()).norm() < 1e-12);
  CHECK(patch_origin(surface, {0, 2}).allFinite());
}

TEST_CASE("surface builder: the report's table of domain, knots, patches and locals") {
  for (Topology u : {Topology::open, Topology::closed}) {
    for (Topology v : {Topology::open, Topology::closed}) {
      BlendingSurfaceObject object;
      object.topology_u = u;
      object.topology_v = v;
      const BlendingSurface surface = build_surface(object, Animation{});
      const auto check_row = [](const DirectionSummary& row, Topology topology, int n) {
        const bool closed = topology == Topology::closed;
        CHECK(row.topology == topology);
        CHECK(row.locals == n);
        CHECK(row.patches == (closed ? n : n - 1));
        CHECK(row.first_knot == 1);
        CHECK(row.last_knot == (closed ? n + 1 : n));
        CHECK(row.knots.size() == static_cast<std::size_t>(closed ? n + 3 : n + 2));
        CHECK(row.knots[static_cast<std::size_t>(row.first_knot)] == row.start);
        CHECK(row.knots[static_cast<std::size_t>(row.last_knot)] == row.end);
        CHECK(row.start == doctest::Approx(-pi));
        CHECK(row.end == doctest::Approx(pi));
      };
      check_row(summary_u(surface), u, 6);
      check_row(summary_v(surface), v, 4);
    }
  }
}

TEST_CASE("surface builder: every B-function and the largest counts build") {
  for (const BlendingFamily& family : blending_families()) {
    CAPTURE(family.id);
    BlendingSurfaceObject object = edited(torus_surface(), Topology::closed, Topology::open);
    object.blending = family.kind;
    object.blending_parameter = family.parameter_max > 0 ? family.parameter_max : 64;
    const BlendingSurface surface = build_surface(object, Animation{});
    CHECK(surface.blending().kind() == family.kind);
    if (family.parameter_max > 0) CHECK(surface.blending().parameter() == family.parameter_max);
    CHECK(surface.evaluate(1, 1).s.allFinite());
  }
  BlendingSurfaceObject object;
  object.locals_u = object.locals_v = max_locals;
  object.edits[{127, 127}].translation.z() = 0.1;
  const BlendingSurface surface = build_surface(object, Animation{});
  CHECK(surface.local(127, 127).translation().allFinite());
}

TEST_CASE("surface builder: every model is built closed as far as it can be, of both kinds of patches, and edited") {
  for (const ModelRow& row : model_kinds()) {
    for (const LocalSurfaceKind kind : {LocalSurfaceKind::sub_surface, LocalSurfaceKind::bezier_hermite}) {
      CAPTURE(row.id);
      BlendingSurfaceObject object = edited(make_model(row.kind), Topology::closed, Topology::closed);
      if (!closes_u(object.model)) object.topology_u = Topology::open;
      if (!closes_v(object.model)) object.topology_v = Topology::open;
      object.patches = {kind, 2, 3};
      REQUIRE(seam_problem(object).message.empty());
      Animation animation;
      animation.time = 1;
      const BlendingSurface surface = build_surface(object, animation);
      CHECK(surface.shape() == object.patches);
      for (int i = 0; i < object.locals_u; ++i) {
        for (int j = 0; j < object.locals_v; ++j) {
          // Poles and other places without a tangent plane have a frame too.
          const Eigen::Matrix3d f = patch_frame(surface, {i, j});
          CHECK((f.transpose() * f - Eigen::Matrix3d::Identity()).norm() < 1e-12);
          CHECK(f.determinant() > 0.999);
          const Eigen::Vector2d c = surface.centre(i, j);
          const double size = 1 + patch_origin(surface, {i, j}).norm();
          CHECK((surface.evaluate(c.x(), c.y()).s - patch_origin(surface, {i, j})).norm() < 1e-12 * size);
        }
      }
    }
  }
}

TEST_CASE("surface builder: twisted seams are closed, and an edited patch reaches across them") {
  for (const char* id : {"moebius", "figure-eight-klein-bottle", "klein-bottle", "boy"}) {
    CAPTURE(id);
    BlendingSurfaceObject object;
    object.model = make_catalogue_surface(id).value();
    if (!closes_u(object.model)) object.topology_u = Topology::open;
    object.edits[{0, 0}].translation = {0, 0, 0.3};
    const BlendingSurface surface = build_surface(object, Animation{});
    const bool in_u = surface.twist_u().has_value();
    REQUIRE(in_u != surface.twist_v().has_value());
    const double reflection = in_u ? surface.twist_u()->reflection : surface.twist_v()->reflection;
    const KnotVector &turn = in_u ? surface.knots_u() : surface.knots_v(),
                     &other = in_u ? surface.knots_v() : surface.knots_u();
    const auto at = [&](double along, double across) {
      return in_u ? surface.evaluate(along, across).s : surface.evaluate(across, along).s;
    };
    const double before = std::nextafter(turn.end(), turn.start());
    for (int k = 0; k < 20; ++k) {
      const double t = other.start() + other.period() * k / 20;
      CHECK((at(before, t) - at(turn.start(), reflection - t)).norm() < 1e-12);
    }
  }
}

}  // namespace knotwork::scene::surface_builder_test
