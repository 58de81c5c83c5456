#include "knotwork/surface/model_surface.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "knotwork/surface/surface_measures.h"
#include "unit/oracle.h"

namespace knotwork::model_surface_test {
using namespace test;

namespace {

using std::numbers::pi;

std::string error_path(const ModelSurface& model) {
  const Status status = validate(model);
  return status.has_value() ? "no error" : status.error().path;
}

}  // namespace

TEST_CASE("the sheet's corners are plane, cylinders and torus") {
  Sheet sheet{0, 0, 0.5, 1.2, 0.3, 0.4};
  for (const double u : {-pi, -2.0, -1e-9, 0.0, 0.7, pi}) {
    for (const double v : {-pi, -1.0, 0.0, 1e-12, 2.5, pi}) {
      CAPTURE(u);
      CAPTURE(v);
      sheet.bend_u = sheet.bend_v = 0;
      CHECK(close(evaluate(sheet, u, v).s, {0, 0.5 * u, 0.3 * v}, oracle_tolerance, 1));
      sheet.bend_u = 1;
      CHECK(close(evaluate(sheet, u, v).s, {1.2 * std::cos(u), 1.2 * std::sin(u), 0.3 * v}, oracle_tolerance));
      sheet.bend_u = 0, sheet.bend_v = 1;
      CHECK(close(evaluate(sheet, u, v).s, {0.4 * std::cos(v), 0.5 * u, 0.4 * std::sin(v)}, oracle_tolerance));
      sheet.bend_u = 1;
      const SurfaceJet rolled = evaluate(sheet, u, v), torus = evaluate(torus_surface(1.2, 0.4, 0.4), u, v);
      for (int k = 0; k < 6; ++k) CHECK(close(jet_part(rolled, k), jet_part(torus, k), oracle_tolerance, 1));
    }
  }
}

TEST_CASE("a sheet is closed in a direction exactly when its bend is 1") {
  for (const double bend : {0.0, 0.3, std::nextafter(1.0, 0.0), 1.0}) {
    const SurfaceDomain u = domain(Sheet{bend, 0.5}), v = domain(Sheet{0.5, bend});
    CHECK((u.closure_u == Closure::closed) == (bend == 1));
    CHECK(u.closure_v == Closure::open);
    CHECK((v.closure_v == Closure::closed) == (bend == 1));
    CHECK(v.closure_u == Closure::open);
  }
}

TEST_CASE("the batch form is the single form") {
  const double u[] = {-1, 0, 0.3, 2}, v[] = {-2, 0.1, 1};
  for (const ModelSurface& model : {ModelSurface(plane_surface()), ModelSurface(cylinder_surface()),
                                    ModelSurface(torus_surface()), ModelSurface(Sheet{0.4, 0.7})}) {
    std::vector<SurfaceJet> out(12);
    evaluate_grid(model, u, v, out);
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = 0; b < 3; ++b) {
        const SurfaceJet single = evaluate(model, u[a], v[b]);
        for (int k = 0; k < 6; ++k) CHECK(jet_part(out[a * 3 + b], k) == jet_part(single, k));
      }
    }
  }
}

TEST_CASE("models have names") {
  CHECK(model_name(plane_surface()) == "plane");
  CHECK(model_name(cylinder_surface()) == "cylinder");
  CHECK(model_name(torus_surface()) == "torus");
  CHECK(model_name(Sheet{}) == "sheet");
  CHECK(model_name(make_catalogue_surface("boy").value()) == "Boy surface");
}

TEST_CASE("validate names the member that is wrong") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const ModelSurface& model :
       {ModelSurface(plane_surface()), ModelSurface(cylinder_surface()), ModelSurface(torus_surface()),
        ModelSurface(Sheet{}), ModelSurface(Sheet{0, 0}), ModelSurface(Sheet{0.5, 1})}) {
    CHECK(error_path(model) == "no error");
  }
  CHECK(error_path(plane_surface({nan, 0, 0})) == "originX");
  CHECK(error_path(plane_surface({0, 0, 0}, {0, inf, 0})) == "uAxisY");
  CHECK(error_path(plane_surface({0, 0, 0}, {0, 0, 0})) == "uAxisX");
  CHECK(error_path(plane_surface({0, 0, 0}, {1, 0, 0}, {0, 0, 1e300})) == "vAxisZ");
  CHECK(error_path(plane_surface({0, 0, 0}, {1, 2, 3}, {-2, -4, -6})) == "vAxisX");
  CHECK(error_path(CatalogueSurface{-1}) == "row");
  for (const double bad : {0.0, -1.0, 1e9, nan, inf}) {
    CHECK(error_path(cylinder_surface(bad, 1, 1)) == "radiusX");
    CHECK(error_path(cylinder_surface(1, bad, 1)) == "radiusY");
    CHECK(error_path(cylinder_surface(1, 1, bad)) == "height");
    CHECK(error_path(torus_surface(bad, 1, 1)) == "wheelRadius");
    CHECK(error_path(torus_surface(1, bad, 1)) == "tubeRadius");
    CHECK(error_path(torus_surface(1, 1, bad)) == "tubeHeight");
    CHECK(error_path(Sheet{1, 1, bad, 1, 1, 1}) == "flat_radius_u");
    CHECK(error_path(Sheet{1, 1, 1, bad, 1, 1}) == "closed_radius_u");
    CHECK(error_path(Sheet{1, 1, 1, 1, bad, 1}) == "flat_radius_v");
    CHECK(error_path(Sheet{1, 1, 1, 1, 1, bad}) == "closed_radius_v");
  }
  for (const double bad : {-0.01, 1.01, nan, inf}) {
    CHECK(error_path(Sheet{bad, 1}) == "bend_u");
    CHECK(error_path(Sheet{1, bad}) == "bend_v");
  }
}

}  // namespace knotwork::model_surface_test
