#include "knotwork/surface/surface_catalogue.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "knotwork/surface/model_surface.h"
#include "knotwork/surface/surface_measures.h"
#include "unit/catalogue_cases.h"
#include "unit/curvature_bounds.h"

namespace knotwork::surface_catalogue_test {
using namespace test;

namespace {

using std::numbers::pi;

struct Catalogued {
  const char* id;
  std::vector<double> measures;
};
/// What the oracle's cases are here.
const std::map<std::string, Catalogued> catalogued = {
    {"plane((3,4,5),(1,4,3),(1,1,2))", {"plane", {3, 4, 5, 1, 4, 3, 1, 1, 2}}},
    {"cylinder(2,3.5,5)", {"cylinder", {2, 3.5, 5}}},
    {"torus(1,0.4,0.6)", {"torus", {1, 0.4, 0.6}}},
    {"sphere(2)", {"sphere", {2}}},
    {"cone(3,5)", {"cone", {3, 5}}},
    {"circular(2)", {"disc", {2}}},
    {"apple(1)", {"apple", {1}}},
    {"apple2(1)", {"second-apple", {1}}},
    {"asteroidal_sphere(1,1,1)", {"asteroidal-sphere", {1, 1, 1}}},
    {"bent_horns", {"bent-horns", {1}}},
    {"bohemian_dome(5,2,2)", {"bohemian-dome", {5, 2, 2}}},
    {"figure8_klein_bottle(4)", {"figure-eight-klein-bottle", {4, 1}}},
    {"boy", {"boy", {1}}},
    {"crosscap(1)", {"cross-cap", {1}}},
    {"steiner(1)", {"steiner", {1}}},
    {"dini(1,0.2)", {"dini", {1, 0.2}}},
    {"eight", {"eight", {1}}},
    {"enneper", {"enneper", {1}}},
    {"helicoid(1,1,0.5)", {"helicoid", {1, 1, 0.5}}},
    {"klein_bottle(6,16,4)_first_half", {"klein-bottle", {6, 16, 4}}},
    {"klein_bottle(6,16,4)_second_half", {"klein-bottle", {6, 16, 4}}},
    {"kuen(1)", {"kuen", {1}}},
    {"moebius(2,1)", {"moebius", {2, 1}}},
    {"seashell", {"seashell", {1}}},
    {"sine(1)", {"sine", {1}}},
    {"slippers", {"slippers", {1}}},
    {"swallowtail", {"swallowtail", {1}}},
    {"trianguloid_trefoil", {"trianguloid-trefoil", {1}}},
    {"whitney_umbrella", {"whitney-umbrella", {1}}},
};

/// The oracle's words for a direction, as `open (apex at u=h)` or `twisted: S(u+pi,v)=S(u,pi-v)`.
void check_direction(const CatalogueDirection& direction, const Interval& interval, const nlohmann::json& bounds,
                     const std::string& closure) {
  CAPTURE(closure);
  CHECK(close(interval.start, bounds[0].get<double>(), oracle_tolerance));
  CHECK(close(interval.end, bounds[1].get<double>(), oracle_tolerance));
  const auto begins = [&](const char* word) { return closure.rfind(word, 0) == 0; };
  const auto contains = [&](const char* word) { return closure.find(word) != std::string::npos; };
  CHECK((direction.closure == Closure::closed) == begins("closed"));
  CHECK((direction.closure == Closure::twisted) == begins("twisted"));
  CHECK((direction.closure == Closure::open) == (begins("open") || begins("poles")));
  if (direction.closure == Closure::twisted) {
    CHECK(direction.reflection == (contains("pi-v") || contains("pi-u") ? pi : 0));
  }
  // The eight surface is closed where it has its poles; the oracle says closed.
  if (direction.closure == Closure::open) {
    CHECK(direction.pole_at_start == (begins("poles") || contains("pole at u=0")));
    CHECK(direction.pole_at_end == (begins("poles") || contains("apex at u=h")));
  }
}

}  // namespace

TEST_CASE("oracle 09: the surfaces with all partials, normal, K, H, domains, closure and poles") {
  const nlohmann::json& surfaces = load_oracle("09_catalog.json")["surfaces"];
  REQUIRE(surfaces.size() == 29);
  std::set<std::string> seen;
  for (const nlohmann::json& oracle : surfaces) {
    read_case(oracle);
    const std::string name = oracle["name"];
    CAPTURE(name);
    REQUIRE(catalogued.count(name) == 1);
    const Catalogued& entry = catalogued.at(name);
    seen.insert(entry.id);
    const Result<CatalogueSurface> made = make_catalogue_surface(entry.id, entry.measures);
    REQUIRE(made.has_value());
    const CatalogueSurface& surface = made.value();
    const CatalogueSurfaceRow& row = *find_catalogue_surface(entry.id);
    const SurfaceDomain where = domain(surface);
    if (name == "klein_bottle(6,16,4)_second_half") {  // says of u: see first half
      CHECK(where.u.end == oracle["u_domain"][1].get<double>());
    } else {
      nlohmann::json bounds = oracle["u_domain"];
      if (name == "klein_bottle(6,16,4)_first_half") bounds[1] = 2 * pi;
      check_direction(row.u, where.u, bounds, oracle["closure_u"]);
    }
    check_direction(row.v, where.v, oracle["v_domain"], oracle["closure_v"]);

    REQUIRE(oracle["points"].size() == 4);
    for (const nlohmann::json& point : oracle["points"]) {
      const SurfaceJet jet = evaluate(surface, point["u"].get<double>(), point["v"].get<double>());
      for (int k = 0; k < 6; ++k) {
        CAPTURE(jet_names[k]);
        CHECK(close(jet_part(jet, k), vector3(point[jet_names[k]]), oracle_tolerance));
      }
      const SurfaceCurvature c = curvature(jet);
      const CurvatureScale natural = curvature_scale(jet);
      CHECK(c.regular);
      CHECK(close(unit_normal(jet), vector3(point["unit_normal"]), oracle_tolerance));
      CHECK(close(c.gaussian, point["K"].get<double>(), oracle_tolerance, natural.gaussian));
      CHECK(close(c.mean, point["H"].get<double>(), oracle_tolerance, natural.mean));
    }
  }
  CHECK(seen.size() == surface_catalogue().size());
}

TEST_CASE("the table of surfaces: ids, labels, measures, and every measure's errors") {
  CHECK(surface_catalogue().size() == 28);
  std::set<std::string_view> ids, labels, names;
  for (const CatalogueSurfaceRow& row : surface_catalogue()) {
    CHECK(ids.insert(row.id).second);
    CHECK(labels.insert(row.label).second);
    CHECK(names.insert(row.name).second);
    CHECK(find_catalogue_surface(row.id) == &row);
    CHECK((row.u.unit < static_cast<int>(row.measures.size()) && row.v.unit < static_cast<int>(row.measures.size())));
    check_row(row, [](std::string_view id, const std::vector<double>& m) { return make_catalogue_surface(id, m); });
  }
  CHECK(find_catalogue_surface("no-such-surface") == nullptr);
  CHECK(make_catalogue_surface("no-such-surface").error().path == "id");
}

TEST_CASE("a plane needs two directions") {
  const auto path = [](std::vector<double> axes) {
    axes.insert(axes.begin(), {1, 2, 3});
    return make_catalogue_surface("plane", axes).error().path;
  };
  CHECK(path({0, 0, 0, 0, 2, 0}) == "uAxisX");
  CHECK(path({2, 0, 0, 0, 0, 0}) == "vAxisX");
  CHECK(path({1, 2, 3, -2, -4, -6}) == "vAxisX");
}

TEST_CASE("validate() of a surface that nobody made") {
  const CatalogueSurface torus = make_catalogue_surface("torus").value();
  check_unmade(torus, find_catalogue_surface("torus")->measures, static_cast<int>(surface_catalogue().size()));
  CatalogueSurface plane = make_catalogue_surface("plane").value();
  for (std::size_t k = 3; k < 6; ++k) plane.measures[k] = 0;
  CHECK(validate(plane).error().path == "uAxisX");
}

TEST_CASE("plane, cylinder and torus have functions of their own") {
  CHECK(plane_surface() == make_catalogue_surface("plane").value());
  CHECK(cylinder_surface() == make_catalogue_surface("cylinder").value());
  CHECK(torus_surface() == make_catalogue_surface("torus").value());
  CHECK(plane_surface({1, 2, 3}, {4, 5, 6}, {7, 8, 10}) ==
        make_catalogue_surface("plane", std::array{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0}).value());
  CHECK(cylinder_surface(1, 1.3, 2) == make_catalogue_surface("cylinder", std::array{1.0, 1.3, 2.0}).value());
  CHECK(torus_surface(1, 0.4, 0.6) == make_catalogue_surface("torus", std::array{1.0, 0.4, 0.6}).value());
}

TEST_CASE("the grid form of a catalogue surface is the single form") {
  const double u[] = {-1, 0, 0.3, 2}, v[] = {-0.5, 0.1, 1};
  for (const CatalogueSurfaceRow& row : surface_catalogue()) {
    const CatalogueSurface surface = make_catalogue_surface(row.id).value();
    std::vector<SurfaceJet> out(12);
    evaluate_grid(surface, u, v, out);
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = 0; b < 3; ++b) {
        const SurfaceJet single = evaluate(surface, u[a], v[b]);
        for (int k = 0; k < 6; ++k) CHECK(jet_part(out[a * 3 + b], k) == jet_part(single, k));
      }
    }
  }
}

TEST_CASE("beyond their logarithms' end, apple, Dini's and Kuen's surface stay where they are") {
  for (const char* id : {"apple", "dini", "kuen"}) {
    const CatalogueSurface surface = make_catalogue_surface(id).value();
    const Interval v = domain(surface).v;
    for (const double beyond : {1e-9, 0.5, 10.0, 1e300}) {
      const SurfaceJet below = evaluate(surface, 0.7, v.start - beyond), start = evaluate(surface, 0.7, v.start);
      const SurfaceJet above = evaluate(surface, 0.7, v.end + beyond), end = evaluate(surface, 0.7, v.end);
      for (int k = 0; k < 6; ++k) {
        CHECK(jet_part(below, k) == jet_part(start, k));
        CHECK(jet_part(above, k) == jet_part(end, k));
      }
    }
  }
}

}  // namespace knotwork::surface_catalogue_test
