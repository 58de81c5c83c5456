#include "knotwork/curve/curve_catalogue.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "unit/catalogue_cases.h"

namespace knotwork::curve_catalogue_test {
using namespace test;

namespace {

using std::numbers::pi;
using Derivatives = std::array<Eigen::Vector3d, 4>;

struct Catalogued {
  const char* id;
  std::vector<double> measures;
};
/// What the oracle's cases are here.
const std::map<std::string, Catalogued> catalogued = {
    {"circle(r=5)", {"circle", {5}}},
    {"line(p=(1,2,3),v=(2,-1,4))", {"line", {1, 2, 3, 2, -1, 4}}},
    {"arc(speed=2,curvature=0.5)", {"arc", {2, 0.5}}},
    {"rose(n=7,m=4,r=5)", {"rose", {7, 4, 5}}},
    {"rose(n=3,m=1,r=5)", {"rose", {3, 1, 5}}},
    {"butterfly(size=5)", {"butterfly", {5}}},
    {"chrysanthemum(r=1)", {"chrysanthemum", {1}}},
    {"report_model", {"report-curve", {1}}},
    {"helix(r=1,pitch=0.25)", {"helix", {1, 0.25, 2}}},
    {"heart", {"heart", {1}}},
    {"astroid(r=3)", {"astroid", {3}}},
    {"nephroid(a=1)", {"nephroid", {1}}},
    {"epitrochoid(R=3,r=1,d=2)", {"epitrochoid", {3, 1, 2, 1}}},
    {"lissajous(3,2,5)", {"lissajous", {3, 2, 5, 0.5, 1, 1}}},
    {"trefoil_knot", {"trefoil-knot", {1}}},
    {"torus_knot(p=2,q=3,R=2,r=1)", {"torus-knot", {2, 3, 2, 1}}},
    {"viviani(a=1)", {"viviani", {1}}},
    {"clelia(r=2,m=3)", {"clelia", {2, 3}}},
};

/// |c' x c''| / |c'|^3 and (c' x c'').c''' / |c' x c''|^2, the latter 0 where the curve is straight.
struct Bending {
  double curvature, torsion;
};
Bending bending(const Derivatives& c) {
  const Eigen::Vector3d cross = c[1].cross(c[2]);
  const double square = cross.squaredNorm(), speed = c[1].norm();
  return {cross.norm() / (speed * speed * speed), square == 0 ? 0 : cross.dot(c[3]) / square};
}

}  // namespace

TEST_CASE("oracle 09: the curves with three derivatives, curvature, torsion, domain and closure") {
  const nlohmann::json& curves = load_oracle("09_catalog.json")["curves"];
  REQUIRE(curves.size() == 18);
  std::set<std::string> seen;
  for (const nlohmann::json& oracle : curves) {
    read_case(oracle);
    const std::string name = oracle["name"];
    CAPTURE(name);
    REQUIRE(catalogued.count(name) == 1);
    const Catalogued& entry = catalogued.at(name);
    seen.insert(entry.id);
    const Result<CatalogueCurve> made = make_catalogue_curve(entry.id, entry.measures);
    REQUIRE(made.has_value());
    const CatalogueCurve& curve = made.value();
    const Interval where = domain(curve);
    CHECK(close(where.start, oracle["domain"][0].get<double>(), oracle_tolerance));
    CHECK(close(where.end, oracle["domain"][1].get<double>(), oracle_tolerance));
    CHECK((find_catalogue_curve(entry.id)->topology == Topology::closed) == oracle["closed"].get<bool>());

    const char* parts[] = {"c", "c1", "c2", "c3"};
    double scale[4] = {};
    for (const nlohmann::json& point : oracle["points"]) {
      for (int k = 0; k < 4; ++k) scale[k] = std::max(scale[k], vector3(point[parts[k]]).norm());
    }
    REQUIRE(oracle["points"].size() == 5);
    for (const nlohmann::json& point : oracle["points"]) {
      Derivatives c;
      evaluate(curve, point["t"].get<double>(), c);
      for (std::size_t k = 0; k < 4; ++k) {
        CAPTURE(parts[k]);
        CHECK(close(c[k], vector3(point[parts[k]]), oracle_tolerance, scale[k]));
      }
      const Bending b = bending(c);
      // Both are known relative to what cancels in them: |c''|/|c'|^2 and |c'||c''||c'''|/|c' x c''|^2.
      const double speed = c[1].norm(), cross = c[1].cross(c[2]).norm();
      const double turning = c[2].norm() / (speed * speed);
      const double twisting = cross == 0 ? 0 : speed * c[2].norm() * c[3].norm() / (cross * cross);
      CHECK(close(b.curvature, point["curvature"].get<double>(), oracle_tolerance, turning));
      CHECK(close(b.torsion, point["torsion"].get<double>(), oracle_tolerance, twisting));
    }
  }
  CHECK(seen.size() == curve_catalogue().size());
}

TEST_CASE("the table of curves: ids, labels, measures, and every measure's errors") {
  CHECK(curve_catalogue().size() == 17);
  std::set<std::string_view> ids, labels;
  for (const CatalogueCurveRow& row : curve_catalogue()) {
    CHECK(ids.insert(row.id).second);
    CHECK(labels.insert(row.label).second);
    CHECK(find_catalogue_curve(row.id) == &row);
    check_row(row, [](std::string_view id, const std::vector<double>& m) { return make_catalogue_curve(id, m); });
  }
  CHECK(find_catalogue_curve("no-such-curve") == nullptr);
  CHECK(make_catalogue_curve("no-such-curve").error().path == "id");
  CHECK(make_catalogue_curve("").error().path == "id");
}

TEST_CASE("a line needs a direction") {
  CHECK(make_catalogue_curve("line", std::array{1.0, 2.0, 3.0, 0.0, 0.0, 0.0}).error().path == "directionX");
  CHECK(make_catalogue_curve("line", std::array{1.0, 2.0, 3.0, 0.0, 0.0, 1e-9}).error().path == "directionX");
  CHECK(make_catalogue_curve("line", std::array{1.0, 2.0, 3.0, 0.0, 0.0, -2.0}).has_value());
}

TEST_CASE("validate() of a curve that nobody made") {
  const CatalogueCurve knot = make_catalogue_curve("torus-knot").value();
  check_unmade(knot, find_catalogue_curve("torus-knot")->measures, static_cast<int>(curve_catalogue().size()));
  CatalogueCurve line = make_catalogue_curve("line").value();
  for (std::size_t k = 3; k < 6; ++k) line.measures[k] = 0;
  CHECK(validate(line).error().path == "directionX");
}

TEST_CASE("domains follow the measures") {
  const auto end = [](std::string_view id, std::vector<double> measures) {
    return domain(make_catalogue_curve(id, measures).value()).end;
  };
  CHECK(close(end("arc", {3, 0.25}), 2 * pi / 0.75, 1e-15));
  CHECK(close(end("helix", {1, 1, 0.5}), pi, 1e-15));
  // n/m in lowest terms: 3/1, 1/2 and 2/3.
  CHECK(close(end("rose", {9, 3, 1}), pi, 1e-15));
  CHECK(close(end("rose", {2, 4, 1}), 4 * pi, 1e-15));
  CHECK(close(end("rose", {4, 6, 1}), 6 * pi, 1e-15));
  CHECK(close(end("epitrochoid", {6, 4, 1, 1}), 4 * pi, 1e-15));
  CHECK(close(end("epitrochoid", {7, 24, 1, 1}), 48 * pi, 1e-15));
}

TEST_CASE("the batch form of a catalogue curve is the single form, whatever the order") {
  const std::array t{-1.0, 0.0, 0.3, 9.0};
  for (const CatalogueCurveRow& row : curve_catalogue()) {
    const CatalogueCurve curve = make_catalogue_curve(row.id).value();
    for (int order = 0; order <= 3; ++order) {
      const std::size_t values = static_cast<std::size_t>(order) + 1;
      std::vector<Eigen::Vector3d> batch(t.size() * values);
      evaluate(curve, t, order, batch);
      for (std::size_t m = 0; m < t.size(); ++m) {
        Derivatives single;
        evaluate(curve, t[m], single);
        for (std::size_t k = 0; k < values; ++k) CHECK(batch[m * values + k] == single[k]);
      }
    }
  }
}

}  // namespace knotwork::curve_catalogue_test
