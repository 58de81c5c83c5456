#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "knotwork/surface/surface_catalogue.h"
#include "knotwork/surface/surface_measures.h"
#include "property/difference_check.h"
#include "unit/catalogue_cases.h"
#include "unit/curvature_bounds.h"

namespace knotwork::surface_catalogue_laws_test {
using namespace test;

namespace {

using std::numbers::pi;

/// The standard surface of each row and some with other measures.
std::vector<CatalogueSurface> surfaces() {
  std::mt19937 random(29);
  std::vector<CatalogueSurface> all;
  for (const CatalogueSurfaceRow& row : surface_catalogue()) {
    all.push_back(make_catalogue_surface(row.id).value());
    for (int k = 0; k < 4; ++k) {
      all.push_back(make_catalogue_surface(row.id, random_measures(row.measures, random)).value());
    }
  }
  return all;
}
const CatalogueSurfaceRow& row_of(const CatalogueSurface& surface) {
  return surface_catalogue()[static_cast<std::size_t>(surface.row)];
}

double between(const Interval& interval, double share) {
  return interval.start + share * (interval.end - interval.start);
}

/// Shares of a domain: none is the middle, where the Klein bottle has a crease.
constexpr double shares[] = {0.09, 0.21, 0.38, 0.46, 0.57, 0.73, 0.88};

/// The largest norm of each vector of the jet: its natural magnitude on this surface.
struct Magnitudes {
  double part[6] = {};
};
Magnitudes magnitudes(const CatalogueSurface& surface) {
  Magnitudes largest;
  const SurfaceDomain where = domain(surface);
  for (const double a : shares) {
    for (const double b : shares) {
      const SurfaceJet jet = evaluate(surface, between(where.u, a), between(where.v, b));
      for (int k = 0; k < 6; ++k) largest.part[k] = std::max(largest.part[k], jet_part(jet, k).norm());
    }
  }
  return largest;
}

/// One direction of a surface, so that u and v need not be written out twice: w along it, x across.
struct Along {
  const CatalogueSurface& surface;
  bool is_u;

  const CatalogueDirection& direction() const { return is_u ? row_of(surface).u : row_of(surface).v; }
  Interval interval() const { return is_u ? domain(surface).u : domain(surface).v; }
  Interval across() const { return is_u ? domain(surface).v : domain(surface).u; }
  SurfaceJet at(double w, double x) const { return is_u ? evaluate(surface, w, x) : evaluate(surface, x, w); }
  /// The jet there as the one here would be: partials of odd order across change sign with the reflection.
  SurfaceJet beyond(double w, double x) const {
    if (direction().closure != Closure::twisted) return at(w, x);
    SurfaceJet jet = at(w, direction().reflection - x);
    (is_u ? jet.sv : jet.su) *= -1;
    jet.suv *= -1;
    return jet;
  }
};

}  // namespace

TEST_CASE("a catalogue surface's partials are the derivatives of its points; a wrong one is rejected") {
  for (const CatalogueSurface& surface : surfaces()) {
    CAPTURE(row_of(surface).id);
    const Magnitudes magnitude = magnitudes(surface);
    DifferenceCheck check{1e-8, {}};
    double largest = 0;
    for (const double part : magnitude.part) largest = std::max(largest, part);
    for (int k = 0; k < 6; ++k) check.scale[k] = std::max(magnitude.part[k], 1e-2 * largest);
    const SurfaceDomain where = domain(surface);
    const double h_u = 1e-3 * (where.u.end - where.u.start), h_v = 1e-3 * (where.v.end - where.v.start);
    bool rejected[6] = {};
    for (const double a : shares) {
      for (const double b : shares) {
        const double u = between(where.u, a), v = between(where.v, b);
        CHECK(partials_agree([&](double x, double y) { return evaluate(surface, x, y); }, u, v, h_u, h_v, check));
        for (int k = 1; k < 6; ++k) {
          const auto wrong = [&](double x, double y) {
            SurfaceJet jet = evaluate(surface, x, y);
            Eigen::Vector3d* parts[] = {&jet.s, &jet.su, &jet.sv, &jet.suu, &jet.suv, &jet.svv};
            *parts[k] *= 1.0001;
            return jet;
          };
          rejected[k] = rejected[k] || !partials_agree(wrong, u, v, h_u, h_v, check);
        }
      }
    }
    for (int k = 1; k < 6; ++k) {
      CAPTURE(jet_names[k]);
      CHECK(rejected[k] == (magnitude.part[k] > 1e-9 * largest));
    }
  }
}

TEST_CASE("directions are closed, twisted and open as flagged, in value and partials") {
  for (const CatalogueSurface& surface : surfaces()) {
    CAPTURE(row_of(surface).id);
    const Magnitudes magnitude = magnitudes(surface);
    for (const bool is_u : {true, false}) {
      CAPTURE(is_u);
      const Along along{surface, is_u};
      const Interval w = along.interval(), x = along.across();
      double gap = 0, unreflected = 0;
      for (const double b : {0.0, 0.09, 0.2, 0.38, 0.5, 0.57, 0.73, 0.88, 1.0}) {
        const double across = between(x, b);
        const SurfaceJet start = along.beyond(w.start, across), end = along.at(w.end, across);
        gap = std::max(gap, (end.s - start.s).norm());
        if (along.direction().closure == Closure::open) continue;
        for (int k = 0; k < 6; ++k) {
          CAPTURE(jet_names[k]);
          // A crease keeps the points together only.
          if (k == 0 || row_of(surface).smooth)
            CHECK(close(jet_part(end, k), jet_part(start, k), 1e-13, magnitude.part[k]));
        }
        // The identity everywhere, not at the ends alone.
        for (const double a : shares) {
          for (const int turns : {-1, 1}) {
            const double here = between(w, a), there = here + turns * (w.end - w.start);
            const SurfaceJet expected = along.beyond(here, across), actual = along.at(there, across);
            unreflected = std::max(unreflected, (actual.s - along.at(here, across).s).norm());
            for (int k = 0; k < 6; ++k)
              CHECK(close(jet_part(actual, k), jet_part(expected, k), 1e-12, magnitude.part[k]));
          }
        }
      }
      if (along.direction().closure == Closure::open) CHECK(gap > 1e-3);
      if (along.direction().closure == Closure::twisted) CHECK(unreflected > 1e-3);
    }
  }
}

TEST_CASE("at a twisted seam the normal turns round: the surface has one side") {
  for (const CatalogueSurface& surface : surfaces()) {
    const CatalogueSurfaceRow& row = row_of(surface);
    CHECK_FALSE((row.u.closure == Closure::twisted && row.v.closure == Closure::twisted));
    for (const bool is_u : {true, false}) {
      const Along along{surface, is_u};
      if (along.direction().closure != Closure::twisted || !row.smooth) continue;
      CAPTURE(row.id);
      const Interval w = along.interval();
      const double across = between(along.across(), 0.31);
      const SurfaceJet end = along.at(w.end, across), start = along.at(w.start, along.direction().reflection - across);
      CHECK(close(end.s, start.s, 1e-13, 1));
      CHECK(unit_normal(end).dot(unit_normal(start)) < -0.99999);
    }
  }
}

TEST_CASE("the classic Klein bottle has its creases in the middle and at the seam, and no gap there") {
  for (const CatalogueSurface& surface : surfaces()) {
    if (row_of(surface).smooth) continue;
    CHECK(row_of(surface).id == "klein-bottle");
    double middle_jump = 0, seam_jump = 0;
    for (const double v : {0.3, 1.0, 2.5, 4.0}) {
      const SurfaceJet left = evaluate(surface, pi, v), right = evaluate(surface, std::nextafter(pi, 4.0), v);
      CHECK(close(left.s, right.s, 1e-14));
      CHECK(close(left.sv, right.sv, 1e-14));
      middle_jump = std::max(middle_jump, (left.su - right.su).norm() / left.su.norm());
      const SurfaceJet end = evaluate(surface, 2 * pi, v), start = evaluate(surface, 0, pi - v);
      CHECK(close(end.s, start.s, 1e-14));
      CHECK(close(end.sv, Eigen::Vector3d(-start.sv), 1e-14, end.s.norm()));
      seam_jump = std::max(seam_jump, (end.su - start.su).norm() / start.su.norm());
      // Two turns bring it back to itself.
      CHECK(close(evaluate(surface, 0.4 + 4 * pi, v).s, evaluate(surface, 0.4, v).s, 1e-13));
    }
    CHECK(middle_jump > 1e-2);
    CHECK(seam_jump > 1e-2);
  }
}

TEST_CASE("an end of the domain is a pole exactly where flagged") {
  for (const CatalogueSurface& surface : surfaces()) {
    CAPTURE(row_of(surface).id);
    for (const bool is_u : {true, false}) {
      CAPTURE(is_u);
      const Along along{surface, is_u};
      for (const bool at_end : {false, true}) {
        CAPTURE(at_end);
        const double w = at_end ? along.interval().end : along.interval().start;
        const Eigen::Vector3d point = along.at(w, along.across().start).s;
        double spread = 0;
        for (const double b : shares)
          spread = std::max(spread, (along.at(w, between(along.across(), b)).s - point).norm());
        const bool flagged = at_end ? along.direction().pole_at_end : along.direction().pole_at_start;
        CHECK(flagged == (spread < 1e-12));
        if (!flagged) CHECK(spread > 1e-4);
      }
    }
  }
}

TEST_CASE("surfaces with known equations and curvatures obey them") {
  for (const CatalogueSurface& surface : surfaces()) {
    const std::string_view id = row_of(surface).id;
    const CatalogueMeasures& m = surface.measures;
    const SurfaceDomain where = domain(surface);
    CAPTURE(id);
    for (const double a : shares) {
      for (const double b : shares) {
        const SurfaceJet jet = evaluate(surface, between(where.u, a), between(where.v, b));
        const double x = jet.s.x(), y = jet.s.y(), z = jet.s.z();
        const SurfaceCurvature c = curvature(jet);
        if (!c.regular) continue;
        const CurvatureScale natural = curvature_scale(jet);
        if (id == "sphere") CHECK(close(jet.s.norm(), m[0], 1e-14));
        if (id == "sphere") CHECK(close(c.gaussian, 1 / (m[0] * m[0]), 1e-12));
        if (id == "cone") CHECK(close(std::hypot(x, y), m[0] * (1 - z / m[1]), 1e-13));
        if (id == "sine") {
          const double p = x / m[0], q = y / m[0], r = z / m[0];  // (sin u, sin v, sin(u+v))
          const double s = r * r + p * p * q * q - p * p * (1 - q * q) - q * q * (1 - p * p) - p * p * q * q;
          CHECK(close(s * s, 4 * p * p * q * q * (1 - p * p) * (1 - q * q), 1e-12, 1));
        }
        if (id == "steiner") {
          const double xx = x * x, yy = y * y, zz = z * z;
          CHECK(close(xx * yy + yy * zz + zz * xx, m[0] * m[0] * x * y * z, 1e-13, std::pow(m[0], 8)));
        }
        if (id == "whitney-umbrella") CHECK(close(x * x * m[0], y * y * z, 1e-13, x * x * m[0]));
        if (id == "dini") CHECK(close(c.gaussian, -1 / (m[0] * m[0] + m[1] * m[1]), 1e-11, natural.gaussian));
        if (id == "kuen") CHECK(close(c.gaussian, -1 / (m[0] * m[0]), 1e-11, natural.gaussian));
        if (id == "enneper") CHECK(close(c.mean, 0, 1e-11, natural.mean));
        if (id == "helicoid" && m[0] == m[1]) CHECK(close(c.mean, 0, 1e-11, natural.mean));
        if (id == "plane" || id == "disc" || id == "cylinder" || id == "cone") {
          CHECK(close(c.gaussian, 0, 1e-12, natural.gaussian));
        }
      }
    }
  }
}

TEST_CASE("at the limits of its measures, in the corners of its domain, a surface is still finite") {
  for (const CatalogueSurfaceRow& row : surface_catalogue()) {
    CAPTURE(row.id);
    for (int pattern = 0; pattern < 4; ++pattern) {
      std::vector<double> values;
      for (std::size_t k = 0; k < row.measures.size(); ++k) {
        const bool greatest = pattern < 2 ? pattern == 1 : (k + static_cast<std::size_t>(pattern)) % 2 == 0;
        values.push_back(greatest ? row.measures[k].greatest : row.measures[k].least);
      }
      // The axes would be parallel.
      if (row.id == "plane") values[3] = 0;
      const Result<CatalogueSurface> surface = make_catalogue_surface(row.id, values);
      REQUIRE(surface.has_value());
      const SurfaceDomain where = domain(surface.value());
      for (const double a : {0.0, 0.3, 0.5, 1.0}) {
        for (const double b : {0.0, 0.3, 0.5, 1.0}) {
          const SurfaceJet jet = evaluate(surface.value(), between(where.u, a), between(where.v, b));
          for (int k = 0; k < 6; ++k) {
            for (const double coordinate : jet_part(jet, k)) CHECK(std::isfinite(coordinate));
          }
        }
      }
    }
  }
}

}  // namespace knotwork::surface_catalogue_laws_test
