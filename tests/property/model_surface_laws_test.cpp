#include "knotwork/surface/model_surface.h"

#include <cmath>

#include <Eigen/Geometry>

#include "knotwork/surface/surface_measures.h"
#include "property/difference_check.h"

namespace knotwork::model_surface_laws_test {
using namespace test;

namespace {

const ModelSurface models[] = {plane_surface({1, 2, 3}, {1, 2, 0}, {0, 1, 1}),
                               cylinder_surface(1, 1.3, 2),
                               torus_surface(1, 0.4, 0.6),
                               Sheet{0, 0},
                               Sheet{1, 0},
                               Sheet{0, 1},
                               Sheet{1, 1},
                               Sheet{0.3, 0.8},
                               Sheet{1e-9, 1e-5}};

/// Second partials of magnitude below that of the surface itself cannot be told from 0 by differences.
constexpr DifferenceCheck check{1e-9, {1, 1, 1, 1, 1, 1}};

}  // namespace

TEST_CASE("a model's partials are the derivatives of its points") {
  for (const ModelSurface& model : models) {
    CAPTURE(model_name(model));
    const auto f = [&](double u, double v) { return evaluate(model, u, v); };
    const auto halved = [&](double u, double v) {
      SurfaceJet jet = evaluate(model, u, v);
      jet.sv /= 2;
      return jet;
    };
    for (const double u : {-2.0, -0.3, 0.0, 1.1}) {
      for (const double v : {-1.0, 0.0, 0.4, 2.2}) {
        CHECK(partials_agree(f, u, v, 0.01, 0.01, check));
        CHECK_FALSE(partials_agree(halved, u, v, 0.01, 0.01, check));
      }
    }
  }
}

TEST_CASE("a model repeats with its period in the directions it is closed in, all partials too") {
  for (const ModelSurface& model : models) {
    const SurfaceDomain where = domain(model);
    const double period_u = where.u.end - where.u.start, period_v = where.v.end - where.v.start;
    for (const double u : {-2.0, 0.0, 1.1}) {
      for (const double v : {-1.0, 0.4, 2.2}) {
        const SurfaceJet here = evaluate(model, u, v);
        const SurfaceJet next_u = evaluate(model, u - period_u, v), next_v = evaluate(model, u, v - period_v);
        for (int k = 0; k < 6; ++k) {
          if (where.closure_u == Closure::closed) {
            CHECK(close(jet_part(next_u, k), jet_part(here, k), 1e-14, 1));
          } else if (k == 0) {
            CHECK_FALSE(close(next_u.s, here.s, 1e-3, 1));
          }
          if (where.closure_v == Closure::closed) {
            CHECK(close(jet_part(next_v, k), jet_part(here, k), 1e-14, 1));
          } else if (k == 0) {
            CHECK_FALSE(close(next_v.s, here.s, 1e-3, 1));
          }
        }
      }
    }
  }
}

TEST_CASE("while a sheet rolls its points and normals move continuously, and the normal faces outwards") {
  constexpr int steps = 50;
  for (const double u : {-3.0, -1.0, 0.0, 2.0}) {
    for (const double v : {-3.0, -0.5, 0.0, 1.5}) {
      for (int direction = 0; direction < 3; ++direction) {
        SurfaceJet previous;
        for (int k = 0; k <= steps; ++k) {
          const double bend = static_cast<double>(k) / steps;
          const Sheet sheet{direction == 1 ? 0.7 : bend, direction == 0 ? 0.7 : bend};
          const SurfaceJet jet = evaluate(sheet, u, v);
          if (k > 0) {
            CHECK((jet.s - previous.s).norm() < 0.25);
            CHECK(unit_normal(jet).dot(unit_normal(previous)) > 0.97);
          }
          previous = jet;
        }
      }
      const SurfaceJet torus = evaluate(Sheet{}, u, v);
      const Eigen::Vector3d tube_centre = Sheet{}.closed_radius_u * Eigen::Vector3d(std::cos(u), std::sin(u), 0);
      CHECK(close(unit_normal(torus).dot(torus.s - tube_centre), Sheet{}.closed_radius_v, 1e-13));
    }
  }
}

TEST_CASE("an arc keeps its length: a sheet of constant radii bends without stretching at its middle") {
  for (const double bend : {0.0, 1e-8, 0.2, 0.5, 1.0}) {
    for (const double t : {-3.0, -0.1, 0.0, 2.0}) {
      CHECK(close(evaluate(Sheet{0, bend, 0.5, 0.5, 0.4, 0.4}, 0.3, t).sv.norm(), 0.4, 1e-13));
      CHECK(close(evaluate(Sheet{bend, 0, 0.5, 0.5, 0.4, 0.4}, t, 0.3).su.norm(), 0.5, 1e-13));
    }
  }
}

}  // namespace knotwork::model_surface_laws_test
