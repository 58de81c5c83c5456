#include "knotwork/surface/blending_surface.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>

#include "knotwork/surface/surface_measures.h"
#include "unit/curvature_bounds.h"
#include "unit/oracle.h"

namespace knotwork::blending_surface_test {
using namespace test;

namespace {

using std::numbers::pi;

ModelSurface oracle_model(const std::string& description) {
  if (description.starts_with("PTorus")) return torus_surface(1, 0.4, 0.6);
  if (description.starts_with("PCylinder")) return cylinder_surface(2, 3.5, 5);
  if (description.starts_with("PMoebiusStrip(2,1)"))
    return make_catalogue_surface("moebius", std::array{2.0, 1.0}).value();
  if (description.starts_with("PBottle8(4)")) {
    return make_catalogue_surface("figure-eight-klein-bottle", std::array{4.0, 1.0}).value();
  }
  REQUIRE(description.starts_with("PPlane"));
  return plane_surface({3, 4, 5}, {1, 4, 3}, {1, 1, 2});
}

KnotVector oracle_knots(const nlohmann::json& inputs, const std::string& direction) {
  const Topology topology = inputs["closed_" + direction].get<bool>() ? Topology::closed : Topology::open;
  return KnotVector::make(1, topology, inputs["knots_" + direction].get<std::vector<double>>()).value();
}

LocalSurfaces oracle_locals(const nlohmann::json& inputs) {
  if (!inputs.contains("local_type")) return {};
  REQUIRE(inputs["local_type"].get<std::string>().starts_with("tensor Bezier-Hermite of degree (2,2)"));
  return {LocalSurfaceKind::bezier_hermite, 2, 2};
}

/// A seam's entries begin with the part of the jet that they are about, `Sv(u,v_end)=..`: S at the end of the domain.
void check_twisted_seam(const BlendingSurface& surface, const nlohmann::json& seam) {
  const bool in_v = seam.contains("u");
  const double other = seam[in_v ? "u" : "v"], image = seam[in_v ? "u_star" : "v_star"];
  const KnotVector& turn = in_v ? surface.knots_v() : surface.knots_u();
  const auto at = [&](double t, double along) {
    return in_v ? surface.evaluate(t, along) : surface.evaluate(along, t);
  };
  const SurfaceJet end = at(other, turn.end()), start = at(image, turn.start());
  const SurfaceJet inside = at(other, std::nextafter(turn.end(), turn.start()));
  for (const auto& [key, value] : seam.items()) {
    if (key.find('=') == std::string::npos) continue;
    const std::string part = key.substr(0, key.find('('));
    for (int k = 0; k < 6; ++k) {
      if (jet_names[k] != part) continue;
      const double sign = key.find("=-") == std::string::npos ? 1 : -1;
      CHECK(close(jet_part(end, k), vector3(value), oracle_tolerance));
      CHECK(close(jet_part(inside, k), vector3(value), oracle_tolerance));
      CHECK(close(sign * jet_part(start, k), vector3(value), oracle_tolerance));
    }
  }
}

BlendingSurface oracle_surface(const nlohmann::json& inputs) {
  const KnotVector knots_u = oracle_knots(inputs, "u"), knots_v = oracle_knots(inputs, "v");
  std::vector<Eigen::Affine3d> locals;
  for (const nlohmann::json& row : inputs["all_local_matrices_local_to_parent_[i][j]"]) {
    for (const nlohmann::json& matrix : row) locals.push_back(affine3(matrix));
  }
  const BlendingKind kind = find_blending_family(inputs["B_function"].get<std::string>())->kind;
  return BlendingSurface::make(oracle_model(inputs["model"]), knots_u, knots_v, BlendingFunction::make(kind).value(),
                               std::move(locals), oracle_locals(inputs))
      .value();
}

KnotVector knots(int n, Topology topology, double start, double end) {
  return KnotVector::uniform(1, n, topology, start, end).value();
}
BlendingFunction polynomial2() { return BlendingFunction::make(BlendingKind::polynomial2).value(); }

BlendingSurface torus3x4() {
  const ModelSurface model = torus_surface();
  const KnotVector u = knots(3, Topology::closed, 0, 2 * pi), v = knots(4, Topology::closed, 0, 2 * pi);
  return BlendingSurface::make(model, u, v, polynomial2(), BlendingSurface::unmoved_locals(model, u, v)).value();
}

Result<BlendingSurface> make(const ModelSurface& model, const KnotVector& u, const KnotVector& v) {
  const auto n = static_cast<std::size_t>(u.count() * v.count());
  return BlendingSurface::make(model, u, v, polynomial2(), std::vector(n, Eigen::Affine3d::Identity()));
}
std::string error_path(const Result<BlendingSurface>& result) {
  return result.has_value() ? "no error" : result.error().path;
}

}  // namespace

TEST_CASE("oracle 07: blending surfaces of every kind, both forms, all partials, normal, K and H") {
  const nlohmann::json& cases = load_oracle("07_blending_surface.json")["cases"];
  std::set<std::string> done;
  for (const nlohmann::json& entry : cases) {
    const nlohmann::json& inputs = entry["inputs"];
    const std::string name = entry["name"];
    CAPTURE(name);
    done.insert(name);
    read_case(entry);
    const BlendingSurface surface = oracle_surface(inputs);
    CHECK(surface.knots_u().interval_count() == inputs["number_of_intervals"][0].get<int>());
    CHECK(surface.knots_v().interval_count() == inputs["number_of_intervals"][1].get<int>());

    // The natural magnitude of each partial: its largest value in the case. On a plane the second partials vanish
    // wherever unmoved patches meet; there terms as large as those of the moved patch cancel, in K and H too.
    double scale[6] = {};
    for (const nlohmann::json& point : entry["points"]) {
      for (int k = 0; k < 6; ++k) scale[k] = std::max(scale[k], vector3(point[jet_names[k]]).norm());
    }
    const bool flat = model_name(surface.model()) == "plane";
    const double cancelled = flat ? std::max({scale[3], scale[4], scale[5]}) : 0;
    REQUIRE(entry["points"].size() >= 9);
    for (const nlohmann::json& point : entry["points"]) {
      const double u = point["u"], v = point["v"];
      CAPTURE(u);
      CAPTURE(v);
      CHECK(surface.knots_u().span(surface.knots_u().reduced(u)) == point["interval_i_j"][0].get<int>());
      CHECK(surface.knots_v().span(surface.knots_v().reduced(v)) == point["interval_i_j"][1].get<int>());
      const SurfaceJet fast = surface.evaluate(u, v), four = surface.evaluate_four_patches(u, v);
      for (int k = 0; k < 6; ++k) {
        CAPTURE(jet_names[k]);
        CHECK(close(jet_part(fast, k), vector3(point[jet_names[k]]), oracle_tolerance, scale[k]));
        CHECK(close(jet_part(four, k), vector3(point[jet_names[k]]), oracle_tolerance, scale[k]));
      }
      CHECK(close(unit_normal(fast), vector3(point["unit_normal"]), oracle_tolerance));
      const SurfaceCurvature c = curvature(fast);
      const CurvatureScale magnitude = curvature_scale(fast, cancelled);
      CHECK(close(c.gaussian, point["K"].get<double>(), oracle_tolerance, magnitude.gaussian));
      CHECK(close(c.mean, point["H"].get<double>(), oracle_tolerance, magnitude.mean));
    }
    for (const nlohmann::json& seam : entry["seam"]) {
      if (seam.contains("u_star") || seam.contains("v_star")) {
        check_twisted_seam(surface, seam);
        continue;
      }
      const bool in_u = seam.contains("u_end_equals_u_start_at_v");
      const KnotVector& wrapped = in_u ? surface.knots_u() : surface.knots_v();
      const double other = seam[in_u ? "u_end_equals_u_start_at_v" : "v_end_equals_v_start_at_u"];
      for (const double t : {wrapped.start(), wrapped.end(), wrapped.end() + wrapped.period()}) {
        const SurfaceJet jet = in_u ? surface.evaluate(t, other) : surface.evaluate(other, t);
        CHECK(close(jet.s, vector3(seam["S"]), oracle_tolerance));
        CHECK(close(in_u ? jet.su : jet.sv, vector3(seam[in_u ? "Su" : "Sv"]), oracle_tolerance));
      }
    }
  }
  CHECK(done == std::set<std::string>{"torus_3x3_one_patch_polynomial1", "torus_3x3_one_patch_expo_rational",
                                      "torus_3x3_corner_patch_affine", "torus_identity", "plane_3x3_one_patch",
                                      "plane_4x5_two_patches", "cylinder_3x3_one_patch",
                                      "torus_4x4_bezier_hermite_locals_2_2", "moebius_twisted_3x4",
                                      "klein_figure8_twisted_4x4"});
}

TEST_CASE("locals are centred at the knots and start unmoved") {
  const BlendingSurface surface = torus3x4();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) {
      const Eigen::Vector2d centre = surface.centre(i, j);
      CHECK(close(centre.x(), 2 * pi * i / 3, 1e-15));
      CHECK(close(centre.y(), 2 * pi * j / 4, 1e-15));
      const Eigen::Vector3d origin = evaluate(surface.model(), centre.x(), centre.y()).s;
      CHECK(surface.local(i, j).translation() == origin);
      CHECK(surface.local(i, j).linear() == Eigen::Matrix3d::Identity());
      CHECK(close(surface.model_map(i, j) * Eigen::Vector3d(1, 2, 3), {1, 2, 3}, 1e-15));
      CHECK(surface.evaluate_local(i, j, centre.x(), centre.y()).s == origin);
    }
  }
}

TEST_CASE("set_local moves one local and its model map") {
  BlendingSurface surface = torus3x4();
  const Eigen::Affine3d map =
      Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()) * Eigen::Scaling(1.5);
  surface.set_local(2, 1, map);
  CHECK(surface.local(2, 1).isApprox(map, 0));
  const Eigen::Vector2d centre = surface.centre(2, 1);
  CHECK(close(surface.evaluate_local(2, 1, centre.x(), centre.y()).s, {1, 2, 3}, 1e-15));
  CHECK(close(surface.model_map(2, 1) * evaluate(surface.model(), centre.x(), centre.y()).s, {1, 2, 3}, 1e-15));
  CHECK(close(surface.evaluate(centre.x(), centre.y()).s, {1, 2, 3}, 1e-15));
}

TEST_CASE("points and grids are the single form, bit for bit") {
  BlendingSurface surface = torus3x4();
  surface.set_local(1, 2, Eigen::Affine3d(Eigen::Translation3d(0.1, 0.2, 0.3) * Eigen::Scaling(0.7)));
  std::vector<double> u, v;
  for (int k = 0; k < 9; ++k) u.push_back(0.9 * k - 1);
  for (int k = 0; k < 150; ++k) v.push_back(0.05 * k);
  std::vector<SurfaceJet> grid(u.size() * v.size()), points(u.size() * v.size());
  std::vector<Eigen::Vector2d> uv;
  for (const double a : u) {
    for (const double b : v) uv.emplace_back(a, b);
  }
  surface.evaluate_grid(u, v, grid);
  surface.evaluate(uv, points);
  for (std::size_t n = 0; n < uv.size(); ++n) {
    const SurfaceJet single = surface.evaluate(uv[n].x(), uv[n].y());
    for (int k = 0; k < 6; ++k) {
      REQUIRE(jet_part(grid[n], k) == jet_part(single, k));
      REQUIRE(jet_part(points[n], k) == jet_part(single, k));
    }
  }
}

TEST_CASE("the weights name the four locals, wrapped where the surface is closed, and sum to 1") {
  const BlendingSurface surface = torus3x4();
  const auto w = surface.weights(2 * pi - 0.5, 2 * pi - 0.1);
  CHECK(w[0].i == 2);
  CHECK(w[0].j == 3);
  CHECK(w[1].i == 2);
  CHECK(w[1].j == 0);
  CHECK(w[2].i == 0);
  CHECK(w[2].j == 3);
  CHECK(w[3].i == 0);
  CHECK(w[3].j == 0);
  CHECK(close(w[0].value + w[1].value + w[2].value + w[3].value, 1, 1e-15));
  const BlendingFunction b = polynomial2();
  const double bu = b((2 * pi - 0.5 - 4 * pi / 3) / (2 * pi / 3))[0], bv = b((2 * pi - 0.1 - 1.5 * pi) / (pi / 2))[0];
  CHECK(close(w[3].value, bu * bv, 1e-14));
  CHECK(close(w[1].value, (1 - bu) * bv, 1e-14));
}

TEST_CASE("make refuses what cannot be a blending surface, in words") {
  const Topology open = Topology::open, closed = Topology::closed;
  const KnotVector unit = knots(3, open, 0, 1), unit_closed = knots(3, closed, 0, 1);
  const KnotVector turn = knots(3, closed, 0, 2 * pi), turn_open = knots(3, open, 0, 2 * pi);
  const KnotVector symmetric = knots(3, closed, -pi, pi), symmetric_open = knots(3, open, -pi, pi);

  SUBCASE("a wrong model") {
    CHECK(error_path(make(torus_surface(1, -1, 1), turn, turn)) == "model.tubeRadius");
    CHECK(error_path(make(Sheet{2, 1}, symmetric, symmetric)) == "model.bend_u");
  }
  SUBCASE("a degree other than 1") {
    const KnotVector quadratic = KnotVector::uniform(2, 4, open, 0, 1).value();
    CHECK(error_path(make(plane_surface(), quadratic, unit)) == "knots_u");
    CHECK(error_path(make(plane_surface(), unit, quadratic)) == "knots_v");
  }
  SUBCASE("closing where the model is not closed") {
    const Result<BlendingSurface> result = make(plane_surface(), unit_closed, unit);
    CHECK(error_path(result) == "knots_u");
    CHECK(result.error().message == "The plane is not closed in u, so the surface cannot be closed there.");
    CHECK(error_path(make(plane_surface(), unit, unit_closed)) == "knots_v");
    CHECK(error_path(make(cylinder_surface(), knots(3, closed, -0.5, 0.5), knots(3, closed, -1.5 * pi, 0.5 * pi))) ==
          "knots_u");
    CHECK(error_path(make(Sheet{0.999, 1}, symmetric, symmetric)) == "knots_u");
    CHECK(error_path(make(Sheet{1, 0}, symmetric, symmetric)) == "knots_v");
  }
  SUBCASE("opening is always possible") {
    CHECK(error_path(make(torus_surface(), turn_open, turn_open)) == "no error");
    CHECK(error_path(make(torus_surface(), turn, turn_open)) == "no error");
    CHECK(error_path(make(Sheet{}, symmetric_open, symmetric)) == "no error");
    CHECK(error_path(make(cylinder_surface(), knots(2, open, -0.5, 0.5), knots(3, open, -1.5 * pi, 0.5 * pi))) ==
          "no error");
  }
  SUBCASE("a part of the model's domain may be covered, not more than it") {
    CHECK(error_path(make(plane_surface(), knots(3, open, 0.25, 0.75), unit)) == "no error");
    CHECK(error_path(make(plane_surface(), knots(3, open, -0.1, 1), unit)) == "knots_u");
    CHECK(error_path(make(plane_surface(), unit, knots(3, open, 0, 1.1))) == "knots_v");
    CHECK(error_path(make(torus_surface(), knots(3, closed, 1, 1 + 2 * pi), turn)) == "knots_u");
  }
  SUBCASE("a period that is not the model's") {
    CHECK(error_path(make(torus_surface(), knots(3, closed, 0, 6.28), turn)) == "knots_u");
    CHECK(error_path(make(torus_surface(), turn, knots(3, closed, 0, pi))) == "knots_v");
  }
  SUBCASE("knots that nearly coincide") {
    const KnotVector narrow = KnotVector::make(1, open, {0, 0, 0.5, 0.5 + 1e-12, 1, 1}).value();
    CHECK(error_path(make(plane_surface(), narrow, unit)) == "knots_u");
  }
  SUBCASE("a wrong number of locals") {
    for (const std::size_t n : {0u, 8u, 10u}) {
      const Result<BlendingSurface> result = BlendingSurface::make(plane_surface(), unit, unit, polynomial2(),
                                                                   std::vector(n, Eigen::Affine3d::Identity()));
      CHECK(error_path(result) == "locals");
      CHECK(result.error().message.find('9') != std::string::npos);
    }
  }
  SUBCASE("entries that are not finite, or a map that is not affine") {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e200}) {
      std::vector<Eigen::Affine3d> locals(9, Eigen::Affine3d::Identity());
      locals[4].matrix()(2, 3) = bad;
      CHECK(error_path(BlendingSurface::make(plane_surface(), unit, unit, polynomial2(), locals)) == "locals[4]");
    }
    std::vector<Eigen::Affine3d> locals(9, Eigen::Affine3d::Identity());
    locals[7].matrix()(3, 0) = 1;
    CHECK(error_path(BlendingSurface::make(plane_surface(), unit, unit, polynomial2(), locals)) == "locals[7]");
  }
}

TEST_CASE("a twisted closure needs symmetric knots and a symmetric B-function") {
  const ModelSurface strip = make_catalogue_surface("moebius").value();
  const KnotVector v = knots(3, Topology::closed, -0.5 * pi, 1.5 * pi),
                   v_open = knots(3, Topology::open, -0.5 * pi, 1.5 * pi);
  const KnotVector lopsided = KnotVector::make(1, Topology::open, {-1, -1, 0.1, 1, 1}).value();
  const KnotVector symmetric = KnotVector::make(1, Topology::open, {-0.5, -0.5, -0.1, 0.1, 0.5, 0.5}).value();
  CHECK(error_path(make(strip, symmetric, v)) == "no error");
  CHECK(error_path(make(strip, lopsided, v_open)) == "no error");
  const Result<BlendingSurface> refused = make(strip, lopsided, v);
  CHECK(error_path(refused) == "knots_u");
  CHECK(refused.error().message == "Going round the Möbius strip in v reflects these knots: they must be symmetric.");
  CHECK(error_path(make(strip, knots(3, Topology::closed, -1, 1), v)) == "knots_u");

  const ModelSurface bottle = make_catalogue_surface("klein-bottle").value();
  const KnotVector u = knots(3, Topology::closed, 0, 2 * pi);
  // sigma(v) = pi - v, modulo 2 pi: only an even number of equal intervals is mapped onto itself.
  for (int n = 2; n <= 7; ++n) {
    CHECK(error_path(make(bottle, u, knots(n, Topology::closed, 0, 2 * pi))) == (n % 2 == 0 ? "no error" : "knots_v"));
  }
  CHECK(error_path(make(bottle, u, knots(4, Topology::open, 0, 2 * pi))) == "knots_v");
  // sigma(v) = -v is 2 pi - v: symmetric about the middle of the domain too.
  const ModelSurface eight = make_catalogue_surface("figure-eight-klein-bottle").value();
  const BlendingSurface cut = make(eight, u, knots(4, Topology::open, 0, 2 * pi)).value();
  CHECK(close(cut.twist_u()->reflection, 2 * pi, 1e-15));
  CHECK(cut.wrapped(3, 1) == std::pair(0, 2));

  const BlendingFunction lopsided_b = BlendingFunction::make(ExpoRationalParameters{1, 1, 2, 0.4}).value();
  const auto with = [&](const KnotVector& turn) {
    return BlendingSurface::make(strip, symmetric, turn, lopsided_b,
                                 BlendingSurface::unmoved_locals(strip, symmetric, turn));
  };
  CHECK(error_path(with(v)) == "blending");
  CHECK(error_path(with(v_open)) == "no error");
}

TEST_CASE("index n is index 0 again, the other one reflected at a twisted seam") {
  const BlendingSurface torus = torus3x4();
  CHECK(torus.wrapped(3, 4) == std::pair(0, 0));
  CHECK(torus.wrapped(3, 2) == std::pair(0, 2));
  CHECK_FALSE(torus.twist_u().has_value());
  const KnotVector u = knots(5, Topology::open, -1, 1), v = knots(3, Topology::closed, -0.5 * pi, 1.5 * pi);
  const BlendingSurface strip = make(make_catalogue_surface("moebius").value(), u, v).value();
  CHECK(strip.wrapped(1, 3) == std::pair(3, 0));
  CHECK(strip.wrapped(1, 2) == std::pair(1, 2));
  REQUIRE(strip.twist_v().has_value());
  CHECK(strip.twist_v()->reflection == 0);
  CHECK(strip.twist_v()->mirror == 4);
}

TEST_CASE("Bezier-Hermite locals have degrees from 1 to 3") {
  const KnotVector unit = knots(3, Topology::open, 0, 1);
  const auto path = [&](int degree_u, int degree_v) {
    const ModelSurface model = plane_surface();
    return error_path(BlendingSurface::make(model, unit, unit, polynomial2(),
                                            BlendingSurface::unmoved_locals(model, unit, unit),
                                            {LocalSurfaceKind::bezier_hermite, degree_u, degree_v}));
  };
  CHECK(path(1, 3) == "no error");
  CHECK(path(0, 3) == "shape.degree_u");
  CHECK(path(4, 3) == "shape.degree_u");
  CHECK(path(2, 0) == "shape.degree_v");
  CHECK(path(2, 4) == "shape.degree_v");
}

TEST_CASE("non-uniform knots: locals are centred at them, closed ones with t_0 and t_(n+2) of the period") {
  const double turn = 2 * pi;
  const std::vector<double> inner{0, 1, 1.5, 4, turn};
  std::vector<double> t = inner;
  t.insert(t.begin(), inner[0] - (inner[4] - inner[3]));
  t.push_back(inner[4] + (inner[1] - inner[0]));
  const KnotVector uneven = KnotVector::make(1, Topology::closed, t).value();
  const ModelSurface model = torus_surface();
  BlendingSurface surface = make(model, uneven, uneven).value();
  for (int i = 0; i < 4; ++i) {
    CHECK(surface.centre(i, 3 - i) ==
          Eigen::Vector2d(inner[static_cast<std::size_t>(i)], inner[static_cast<std::size_t>(3 - i)]));
    surface.set_local(i, 0, Eigen::Affine3d(Eigen::Translation3d(i, 0, 0)));
    CHECK(close(surface.evaluate(uneven[i + 1], 0).s, {static_cast<double>(i), 0, 0}, 1e-14, 1));
  }
  t.front() -= 0.1;
  CHECK_FALSE(KnotVector::make(1, Topology::closed, t).has_value());
}

}  // namespace knotwork::blending_surface_test
