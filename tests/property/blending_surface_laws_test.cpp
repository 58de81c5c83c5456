#include <cmath>
#include <tuple>

#include <Eigen/Geometry>

#include "property/difference_check.h"
#include "property/surface_cases.h"

namespace knotwork::blending_surface_laws_test {
using namespace test;

namespace {

/// How many orders of derivatives, 0 to 2, a surface keeps across its knots.
int kept_order(const BlendingSurface& surface) { return std::min(2, surface.blending().order()); }

/// The order of the derivative in the given direction that part k of a jet carries.
int order_in(bool u, int k) {
  constexpr int orders_u[] = {0, 1, 0, 2, 1, 0}, orders_v[] = {0, 0, 1, 0, 1, 2};
  return u ? orders_u[k] : orders_v[k];
}

/// The seed's mistake: the derivatives of the blending weights left out.
SurfaceJet without_weight_derivatives(const BlendingSurface& surface, double u, double v) {
  SurfaceJet sum = surface.evaluate(u, v);
  sum.su.setZero();
  sum.sv.setZero();
  for (const BlendingSurface::Weight& weight : surface.weights(u, v)) {
    const SurfaceJet local = surface.evaluate_local(weight.i, weight.j, u, v);
    sum.su += weight.value * local.su;
    sum.sv += weight.value * local.sv;
  }
  return sum;
}

}  // namespace

TEST_CASE("both evaluation forms agree to 1e-13") {
  for (const SurfaceCase& entry : all_surface_cases()) {
    const BlendingSurface& surface = entry.surface;
    CAPTURE(entry.name);
    const JetScale scale = jet_scale(surface);
    for (const double u : interval_parameters(surface.knots_u(), {0, 0.03, 0.4, 0.5, 0.9, 1})) {
      for (const double v : interval_parameters(surface.knots_v(), {0, 0.1, 0.5, 0.77, 1})) {
        const SurfaceJet fast = surface.evaluate(u, v), four = surface.evaluate_four_patches(u, v);
        for (int k = 0; k < 6; ++k) {
          CAPTURE(jet_names[k]);
          REQUIRE(close(jet_part(fast, k), jet_part(four, k), 1e-13, scale.part[k]));
        }
      }
    }
  }
}

TEST_CASE("partials are the derivatives, relative to their size; wrong ones are rejected") {
  for (const SurfaceCase& entry : all_surface_cases()) {
    const BlendingSurface& surface = entry.surface;
    CAPTURE(entry.name);
    const KnotVector &knots_u = surface.knots_u(), &knots_v = surface.knots_v();
    const JetScale scale = jet_scale(surface);
    DifferenceCheck check;
    // A partial much smaller than usual on the surface is a cancellation; a thousandth of the largest is not.
    for (int k = 0; k < 6; ++k) check.scale[k] = 1e-3 * scale.part[k];
    const auto right = [&](double u, double v) { return surface.evaluate(u, v); };
    int halved_rejected = 0, seed_rejected = 0, slightly_wrong_rejected = 0, points = 0;
    for (const double u : interval_parameters(knots_u, {0.3, 0.7})) {
      for (const double v : interval_parameters(knots_v, {0.4, 0.65})) {
        const int i = knots_u.span(u), j = knots_v.span(v);
        const double h_u = 0.004 * (knots_u[i + 1] - knots_u[i]), h_v = 0.004 * (knots_v[j + 1] - knots_v[j]);
        REQUIRE(partials_agree(right, u, v, h_u, h_v, check));
        ++points;
        for (int part = 1; part < 6; ++part) {
          const auto scaled = [&](double factor) {
            return [&surface, part, factor](double a, double b) {
              SurfaceJet jet = surface.evaluate(a, b);
              Eigen::Vector3d* parts[] = {&jet.s, &jet.su, &jet.sv, &jet.suu, &jet.suv, &jet.svv};
              *parts[part] *= factor;
              return jet;
            };
          };
          halved_rejected += partials_agree(scaled(0.5), u, v, h_u, h_v, check) ? 0 : 1;
          slightly_wrong_rejected += partials_agree(scaled(1.001), u, v, h_u, h_v, check) ? 0 : 1;
        }
        const auto seed = [&](double a, double b) { return without_weight_derivatives(surface, a, b); };
        seed_rejected += partials_agree(seed, u, v, h_u, h_v, check) ? 0 : 1;
      }
    }
    CHECK(halved_rejected == 5 * points);
    CHECK(slightly_wrong_rejected == 5 * points);
    CHECK(seed_rejected == points);
  }
}

TEST_CASE("a local has influence on its support, all of it, and nowhere else: bit for bit, the wrap included") {
  for (const SurfaceCase& entry : all_surface_cases()) {
    if (entry.surface.twist_u() || entry.surface.twist_v()) continue;  // the Moebius strip has a test of its own
    const BlendingSurface& surface = entry.surface;
    CAPTURE(entry.name);
    const KnotVector &knots_u = surface.knots_u(), &knots_v = surface.knots_v();
    const std::vector<double> us = interval_parameters(knots_u, {0, 0.3, 0.7}),
                              vs = interval_parameters(knots_v, {0, 0.4, 0.6});
    std::vector<double> all_u = us, all_v = vs;
    if (!knots_u.closed()) all_u.push_back(knots_u.end());
    if (!knots_v.closed()) all_v.push_back(knots_v.end());
    for (int i = 0; i < knots_u.count(); ++i) {
      for (int j = 0; j < knots_v.count(); ++j) {
        BlendingSurface changed = surface;
        changed.set_local(i, j, Eigen::Translation3d(0.1, -0.2, 0.3) * surface.local(i, j));
        for (const double u : all_u) {
          for (const double v : all_v) {
            const bool inside = in_support(knots_u, i, u) && in_support(knots_v, j, v);
            const Eigen::Vector3d before = surface.evaluate(u, v).s, after = changed.evaluate(u, v).s;
            CAPTURE(u);
            CAPTURE(v);
            REQUIRE((before != after) == inside);
            // P2: a translation tau of local (i,j) adds tau times its weight.
            double weight = 0;
            for (const BlendingSurface::Weight& w : surface.weights(u, v)) {
              if (w.i == i && w.j == j) weight += w.value;
            }
            REQUIRE(close(after - before, weight * Eigen::Vector3d(0.1, -0.2, 0.3), 1e-13, 1));
          }
        }
      }
    }
  }
}

TEST_CASE("the surface and its partials up to the order are continuous across knots and closed seams") {
  // The order is sharp: over all cases the next derivative jumps, or the test would detect nothing.
  int jumps_beyond_order = 0, crossings = 0;
  for (const SurfaceCase& entry : all_surface_cases()) {
    const BlendingSurface& surface = entry.surface;
    CAPTURE(entry.name);
    const JetScale scale = jet_scale(surface);
    for (const bool in_u : {true, false}) {
      const KnotVector& knots = in_u ? surface.knots_u() : surface.knots_v();
      const KnotVector& other = in_u ? surface.knots_v() : surface.knots_u();
      const int first = 2, last = knots.closed() ? knots.count() + 1 : knots.count() - 1;
      for (int k = first; k <= last; ++k) {
        // A parameter one rounding before the knot lies in the interval before; a closed end wraps to the start.
        const double at = knots[k], before = std::nextafter(at, -1e9);
        for (const double t : interval_parameters(other, {0.2, 0.5})) {
          const SurfaceJet left = in_u ? surface.evaluate(before, t) : surface.evaluate(t, before);
          const SurfaceJet right = in_u ? surface.evaluate(at, t) : surface.evaluate(t, at);
          ++crossings;
          for (int part = 0; part < 6; ++part) {
            CAPTURE(jet_names[part]);
            const int order = order_in(in_u, part);
            const Closeness same = close(jet_part(left, part), jet_part(right, part), 1e-11, scale.part[part]);
            if (order <= kept_order(surface)) {
              REQUIRE(same);
            } else if (!same && order == surface.blending().order() + 1) {
              ++jumps_beyond_order;
            }
          }
        }
      }
    }
  }
  CHECK(crossings > 1000);
  CHECK(jumps_beyond_order > 100);
}

TEST_CASE("Hermite property: at a knot the surface has the point and partials of the local there, up to the order") {
  for (const SurfaceCase& entry : all_surface_cases()) {
    const BlendingSurface& surface = entry.surface;
    CAPTURE(entry.name);
    const JetScale scale = jet_scale(surface);
    for (int i = 0; i < surface.knots_u().count(); ++i) {
      for (int j = 0; j < surface.knots_v().count(); ++j) {
        const Eigen::Vector2d centre = surface.centre(i, j);
        const SurfaceJet jet = surface.evaluate(centre.x(), centre.y());
        const SurfaceJet local = surface.evaluate_local(i, j, centre.x(), centre.y());
        for (int part = 0; part < 6; ++part) {
          if (std::max(order_in(true, part), order_in(false, part)) > kept_order(surface)) continue;
          CAPTURE(jet_names[part]);
          REQUIRE(close(jet_part(jet, part), jet_part(local, part), 1e-13, scale.part[part]));
        }
      }
    }
  }
}

TEST_CASE("affine invariance: mapping every local maps the surface") {
  Numbers numbers(4711);
  for (const SurfaceCase& entry : all_surface_cases()) {
    const BlendingSurface& surface = entry.surface;
    CAPTURE(entry.name);
    const Eigen::Affine3d map = numbers.affine();
    BlendingSurface mapped = surface;
    for (int i = 0; i < surface.knots_u().count(); ++i) {
      for (int j = 0; j < surface.knots_v().count(); ++j) mapped.set_local(i, j, map * surface.local(i, j));
    }
    const JetScale scale = jet_scale(surface);
    for (const double u : interval_parameters(surface.knots_u(), {0, 0.3, 0.8})) {
      for (const double v : interval_parameters(surface.knots_v(), {0, 0.5, 0.6})) {
        const SurfaceJet before = surface.evaluate(u, v), after = mapped.evaluate(u, v);
        REQUIRE(close(after.s, map * before.s, 1e-13, scale.part[0]));
        for (int part = 1; part < 6; ++part) {
          const Eigen::Vector3d expected = map.linear() * jet_part(before, part);
          REQUIRE(close(jet_part(after, part), expected, 1e-13, scale.part[part]));
        }
      }
    }
  }
}

TEST_CASE("P1: unmoved locals give the model back whatever the blending function") {
  for (const BlendingFunction& b : case_functions()) {
    for (const ModelSurface& model : {ModelSurface(torus_surface()), ModelSurface(Sheet{1, 1})}) {
      const SurfaceDomain where = domain(model);
      const BlendingSurface surface = unmoved(model, case_knots(3, Topology::closed, where.u, false),
                                              case_knots(4, Topology::open, where.v, true), b);
      for (const double u : interval_parameters(surface.knots_u(), {0, 0.2, 0.5})) {
        for (const double v : interval_parameters(surface.knots_v(), {0, 0.3, 0.9})) {
          const SurfaceJet jet = surface.evaluate(u, v), expected = evaluate(model, u, v);
          // The derivatives of the weights cancel: magnitude of the largest, B'' delta^2 of the steepest function.
          const double scale[] = {1, 10, 10, 100, 100, 100};
          for (int part = 0; part < 6; ++part) {
            REQUIRE(close(jet_part(jet, part), jet_part(expected, part), 1e-13, scale[part]));
          }
        }
      }
    }
  }
}

TEST_CASE("a closed direction repeats with its period, an open one stops at its ends") {
  for (const SurfaceCase& entry : all_surface_cases()) {
    const BlendingSurface& surface = entry.surface;
    CAPTURE(entry.name);
    const KnotVector &u = surface.knots_u(), &v = surface.knots_v();
    const double a = u.start() + 0.37 * u.period(), b = v.start() + 0.61 * v.period();
    const Eigen::Vector3d here = surface.evaluate(a, b).s;
    // A twisted turn reflects the other parameter.
    const double other_b = surface.twist_u() ? surface.twist_u()->reflection - b : b;
    const double other_a = surface.twist_v() ? surface.twist_v()->reflection - a : a;
    const Eigen::Vector3d next_u = surface.evaluate(a + u.period(), other_b).s,
                          next_v = surface.evaluate(other_a, b - v.period()).s;
    if (u.closed()) {
      CHECK(close(next_u, here, 1e-13, 1));
    } else {
      CHECK(next_u == surface.evaluate(u.end(), b).s);
    }
    if (v.closed()) {
      CHECK(close(next_v, here, 1e-13, 1));
    } else {
      CHECK(next_v == surface.evaluate(a, v.start()).s);
    }
  }
}

TEST_CASE("across a twisted seam S and the partial along the turn go on, the one across changes its sign") {
  int seams = 0;
  for (const SurfaceCase& entry : further_surface_cases()) {
    const BlendingSurface& surface = entry.surface;
    for (const bool in_u : {true, false}) {
      const auto& twist = in_u ? surface.twist_u() : surface.twist_v();
      if (!twist) continue;
      ++seams;
      CAPTURE(entry.name);
      const KnotVector &turn = in_u ? surface.knots_u() : surface.knots_v(),
                       &other = in_u ? surface.knots_v() : surface.knots_u();
      const JetScale scale = jet_scale(surface);
      // Into the last interval from its inside, where no wrapping helps.
      const double before = std::nextafter(turn.end(), -1e9);
      for (const double t : interval_parameters(other, {0.1, 0.5, 0.8})) {
        const double image = twist->reflection - t;
        const SurfaceJet end = in_u ? surface.evaluate(before, t) : surface.evaluate(t, before);
        const SurfaceJet start = in_u ? surface.evaluate(turn.start(), image) : surface.evaluate(image, turn.start());
        CHECK(close(end.s, start.s, 1e-13, scale.part[0]));
        const int across = in_u ? 2 : 1, along = in_u ? 1 : 2;
        CHECK(close(jet_part(end, across), -jet_part(start, across), 1e-12, scale.part[across]));
        if (surface.blending().order() < 1) continue;
        CHECK(close(jet_part(end, along), jet_part(start, along), 1e-12, scale.part[along]));
      }
    }
  }
  CHECK(seams == 18);
}

TEST_CASE("a local of a Moebius strip reaches across the seam on the other side, and no further") {
  const ModelSurface model = make_catalogue_surface("moebius").value();
  const double start = domain(model).v.start, end = domain(model).v.end;
  const KnotVector u = KnotVector::make(1, Topology::open, {-1, -1, -0.5, 0.5, 1, 1}).value();
  const KnotVector v = KnotVector::uniform(1, 4, Topology::closed, start, end).value();
  const BlendingFunction b = BlendingFunction::make(BlendingKind::polynomial2).value();
  for (const LocalSurfaceKind kind : {LocalSurfaceKind::sub_surface, LocalSurfaceKind::bezier_hermite}) {
    const BlendingSurface surface = moved(
        BlendingSurface::make(model, u, v, b, BlendingSurface::unmoved_locals(model, u, v), {kind, 2, 2}).value(), 5);
    const double h = (end - start) / 4;
    const auto inside = [&](int i, int j, double a, double c) {
      const bool here = in_support(u, i, a) && v[j] < c && c < v[j + 2];
      return here || (j == 0 && in_support(u, i, -a) && c > end - h);
    };
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        BlendingSurface changed = surface;
        changed.set_local(i, j, Eigen::Translation3d(0.1, -0.2, 0.3) * surface.local(i, j));
        for (const double a : interval_parameters(u, {0, 0.3, 0.5, 0.7})) {
          for (const double c : interval_parameters(v, {0, 0.4, 0.6})) {
            REQUIRE((surface.evaluate(a, c).s != changed.evaluate(a, c).s) == inside(i, j, a, c));
          }
        }
      }
    }
  }
}

TEST_CASE("unmoved Bezier-Hermite locals meet the model at the knots, and a polynomial model everywhere") {
  const BlendingFunction b = BlendingFunction::make(BlendingKind::polynomial3).value();
  for (const CatalogueSurfaceRow& row : surface_catalogue()) {
    const ModelSurface model = make_catalogue_surface(row.id).value();
    CAPTURE(row.id);
    const SurfaceDomain where = domain(model);
    const KnotVector u = KnotVector::uniform(1, 3, Topology::open, where.u.start, where.u.end).value();
    const KnotVector v = KnotVector::uniform(1, 4, Topology::open, where.v.start, where.v.end).value();
    const BlendingSurface surface = BlendingSurface::make(model, u, v, b, BlendingSurface::unmoved_locals(model, u, v),
                                                          {LocalSurfaceKind::bezier_hermite, 2, 2})
                                        .value();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 4; ++j) {
        const Eigen::Vector2d c = surface.centre(i, j);
        const SurfaceJet jet = surface.evaluate(c.x(), c.y()), expected = evaluate(model, c.x(), c.y());
        double largest = 0;
        for (int part = 0; part < 6; ++part) largest = std::max(largest, jet_part(expected, part).norm());
        for (int part = 0; part < 6; ++part) {
          CAPTURE(jet_names[part]);
          CHECK(close(jet_part(jet, part), jet_part(expected, part), 1e-12, largest));
        }
      }
    }
  }
  // Enneper's surface is of degree 3 in u and in v, Whitney's umbrella of degree 1 and 2.
  for (const auto& [id, degree_u, degree_v] : {std::tuple{"enneper", 3, 3}, {"whitney-umbrella", 1, 2}}) {
    const ModelSurface model = make_catalogue_surface(id).value();
    const SurfaceDomain where = domain(model);
    const KnotVector u = case_knots(3, Topology::open, where.u, false),
                     v = case_knots(4, Topology::open, where.v, true);
    const auto locals = BlendingSurface::unmoved_locals(model, u, v);
    const BlendingSurface surface =
        BlendingSurface::make(model, u, v, b, locals, {LocalSurfaceKind::bezier_hermite, degree_u, degree_v}).value();
    const BlendingSurface poorer =
        BlendingSurface::make(model, u, v, b, locals, {LocalSurfaceKind::bezier_hermite, degree_u, 1}).value();
    bool differs = false;
    for (const double a : interval_parameters(u, {0, 0.3, 0.7})) {
      for (const double c : interval_parameters(v, {0, 0.4, 0.6})) {
        CHECK(close(surface.evaluate(a, c).s, evaluate(model, a, c).s, 1e-13, 1));
        differs = differs || (poorer.evaluate(a, c).s - evaluate(model, a, c).s).norm() > 1e-3;
      }
    }
    CHECK(differs);
  }
}

}  // namespace knotwork::blending_surface_laws_test
