// The numbers that the chapters state, `[0.432](fact:bernstein-3-1)`, are what the library computes, to the last digit
// printed.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <doctest/doctest.h>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "knotwork/basis/bernstein.h"
#include "knotwork/basis/bspline_basis.h"
#include "knotwork/curve/closest_point.h"
#include "knotwork/curve/curve_measures.h"
#include "knotwork/scene/blending_curve_figure.h"
#include "knotwork/scene/chapters.h"
#include "knotwork/scene/commands.h"
#include "knotwork/scene/curve_figure.h"
#include "knotwork/scene/document_json.h"
#include "knotwork/scene/fit_edits.h"
#include "knotwork/scene/model_figure.h"
#include "knotwork/scene/subdivision_figure.h"
#include "knotwork/scene/surface_builder.h"

namespace knotwork::scene::facts_test {

namespace {

using std::numbers::pi;

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

const std::filesystem::path shell_folder = KNOTWORK_SHELL_DIR;

/// The object on the stage of a scene's file, or of a start document.
template <class Object>
Object in_scene(const std::string& id) {
  const Document document = parse_document(text_of(shell_folder / "scenes" / (id + ".json"))).value();
  return std::get<Object>(stage_shape(document));
}
template <class Object>
Object at_start(std::string_view id) {
  return std::get<Object>(stage_shape(find_chapter(id)->start_document()));
}

// --- Chapters 1 and 2: basis functions and curves -------------------------------------------------------------------

double bernstein_at(int degree, int k, double t) {
  std::vector<double> all(static_cast<std::size_t>(degree) + 1);
  bernstein(degree, t, all);
  return all[static_cast<std::size_t>(k)];
}

/// b_i(t).
double basis_function(const KnotVector& knots, int i, double t) {
  const int span = knots.span(t), j = i - (span - knots.degree());
  std::vector<double> nonzero(static_cast<std::size_t>(knots.degree()) + 1);
  bspline_basis(knots, span, t, 0, nonzero);
  return j < 0 || j > knots.degree() ? 0 : nonzero[static_cast<std::size_t>(j)];
}

double distance_from_point_5(const BSplineCurve& curve) {
  return closest_point(curve_view(curve), curve.point(5)).value().distance;
}

BSplineCurve uneven_knots() { return spline_of(in_scene<BSplineCurveObject>("uneven-knots")); }

BSplineCurve with_even_knots(const BSplineCurve& curve) {
  const int n = curve.knots().count();
  const KnotVector knots = KnotVector::uniform(3, n, Topology::open, 0, n - 3).value();
  return BSplineCurve::make(knots, {curve.points().begin(), curve.points().end()}).value();
}

double three_rounds(int i) {
  return basis_function(spline_of(in_scene<BSplineCurveObject>("three-rounds")).knots(), i, 1);
}

// --- Chapter 3: fits ------------------------------------------------------------------------------------------------

CurveFit fit_of(FittedCurveObject object, int count) {
  object.count = count;
  return build_fit(object).value();
}
double open_circle(int count) { return fit_of(at_start<FittedCurveObject>("least-squares"), count).fit.rms; }
double closed_circle(int count) { return fit_of(at_start<FittedCurveObject>("least-squares-closed"), count).fit.rms; }
double noisy_arch(int count) { return fit_of(in_scene<FittedCurveObject>("noisy-arch"), count).fit.rms; }

double uneven_data(DataParameters parameters) {
  auto object = in_scene<FittedCurveObject>("uneven-data");
  object.parameters = parameters;
  return fit_of(object, 9).fit.rms;
}

/// Of the matrix of the open circle's fit.
double condition(int count) {
  const CurveFit fit = fit_of(at_start<FittedCurveObject>("least-squares"), count);
  Eigen::MatrixXd a(fit.parameters.size(), count);
  for (int j = 0; j < a.rows(); ++j)
    for (int i = 0; i < count; ++i)
      a(j, i) = basis_function(fit.fit.curve.knots(), i, fit.parameters[static_cast<std::size_t>(j)]);
  const Eigen::VectorXd sigma = Eigen::JacobiSVD<Eigen::MatrixXd>(a).singularValues();
  return sigma[0] / sigma[count - 1];
}

// --- Chapter 4: subdivision -----------------------------------------------------------------------------------------

/// Of the report's seven points, closed.
double distance_from_limit(int degree, int level) {
  auto object = at_start<SubdivisionCurveObject>("subdivision");
  object.degree = degree;
  object.step = 0;
  return SubdivisionFigure(object).distances.at(static_cast<std::size_t>(level)).maximum;
}
double ratio_of_levels(int degree, int level) {
  return distance_from_limit(degree, level) / distance_from_limit(degree, level + 1);
}

// --- Chapters 5 and 6: blending functions and curves ----------------------------------------------------------------

double blending(BlendingKind kind, int parameter, double w, std::size_t derivative) {
  return BlendingFunction::make(kind, parameter).value()(w)[derivative];
}
double slope(BlendingKind kind, int parameter = 0) { return blending(kind, parameter, 0.5, 1); }

/// The circle of eight locals, of which number 2, at pi/2, is pulled.
BlendingCurve pulled_circle(BlendingKind kind, int parameter = 0) {
  auto object = in_scene<BlendingCurveObject>("flat-ends");
  object.blending = kind;
  object.blending_parameter = parameter;
  return build_curve(object, {});
}

using Derivatives = std::array<Eigen::Vector3d, 3>;
Derivatives derivatives(const BlendingCurve& curve, double t) {
  Derivatives c;
  curve.evaluate(t, c);
  return c;
}

double degrees_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / pi;
}

/// On the right of a local's knot; positive where the curve turns left.
double curvature_beyond(const BlendingCurve& curve, int local) {
  return signed_curvature(derivatives(curve, curve.centre(local)), Eigen::Vector3d::UnitZ());
}

/// Between the tangents on both sides of a local's knot.
double corner(const BlendingCurve& curve, int local) {
  const double t = curve.centre(local);
  return degrees_between(derivatives(curve, just_before(t))[1], derivatives(curve, t)[1]);
}

/// The largest f(t) at that many steps an interval.
template <class F>
double largest(const KnotVector& knots, int steps, F f) {
  double most = -std::numeric_limits<double>::infinity();
  for (int i = knots.degree(); i <= knots.last_span(); ++i)
    for (int k = 0; k <= steps; ++k)
      most = std::max(most, f(std::lerp(knots[i], knots[i + 1], static_cast<double>(k) / steps)));
  return most;
}

double largest_bend(BlendingKind kind, int parameter = 0) {
  const BlendingCurve curve = pulled_circle(kind, parameter);
  return largest(curve.knots(), 1000, [&](double t) { return curvature(derivatives(curve, t)); });
}

/// From the report's model curve, of unmoved Taylor polynomials in the place of parts of it.
double distance_from_model(int degree, int locals) {
  BlendingCurveObject object;
  object.locals = locals;
  object.local_kind = LocalCurveKind::bezier_hermite;
  object.local_degree = degree;
  const BlendingCurve curve = build_curve(object, {});
  return largest(curve.knots(), 200, [&](double t) { return (curve(t) - curve.model()(t)).norm(); });
}

double elbow_speed() {
  const BlendingCurve curve = build_curve(in_scene<BlendingCurveObject>("arm"), {});
  Derivatives model;
  curve.model().evaluate(0.5, model);
  return derivatives(curve, 0.5)[1].norm() / model[1].norm();
}

// --- Chapters 7 and 8: surfaces -------------------------------------------------------------------------------------

/// Of the point that is pulled out, at its own place.
double net_weight() {
  const auto object = at_start<BSplineSurfaceObject>("tensor-surface");
  const auto knots = [](const SplineDirection& direction) {
    return KnotVector::make(direction.degree, direction.topology, direction.knots).value();
  };
  return basis_function(knots(object.u), 3, 2) * basis_function(knots(object.v), 2, 1);
}

/// The least (sign -1) or greatest (1) radius of the closed cubic B-spline on a hexagon of radius 1.
double hexagon_radius(double sign) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(6);
  for (int k = 0; k < 6; ++k) points.emplace_back(std::cos(k * pi / 3), std::sin(k * pi / 3), 0);
  const KnotVector knots = KnotVector::uniform(3, 6, Topology::closed, 0, 6).value();
  const BSplineCurve curve = BSplineCurve::make(knots, points).value();
  return sign * largest(knots, 100, [&](double t) { return sign * curve(t).norm(); });
}

/// How far the normal is off, in degrees, where the slopes of the weights are forgotten.
double normal_without_slope() {
  const BlendingSurface surface = build_surface(at_start<BlendingSurfaceObject>("blending-surface"), {});
  // A local that is met beyond the seam is evaluated a period earlier.
  const auto near = [](double t, double centre) { return t - 2 * pi * std::round((t - centre) / (2 * pi)); };
  double most = 0;
  for (int a = 0; a < 144; ++a) {
    for (int b = 0; b < 96; ++b) {
      const double u = -pi + 2 * pi * a / 144, v = -pi + 2 * pi * b / 96;
      Eigen::Vector3d su = Eigen::Vector3d::Zero(), sv = Eigen::Vector3d::Zero();
      for (const BlendingSurface::Weight& weight : surface.weights(u, v)) {
        const Eigen::Vector2d centre = surface.centre(weight.i, weight.j);
        const SurfaceJet local = surface.evaluate_local(weight.i, weight.j, near(u, centre.x()), near(v, centre.y()));
        su += weight.value * local.su;
        sv += weight.value * local.sv;
      }
      const SurfaceJet jet = surface.evaluate(u, v);
      most = std::max(most, degrees_between(jet.su.cross(jet.sv), su.cross(sv)));
    }
  }
  return most;
}

// --- Chapter 9: quality --------------------------------------------------------------------------------------------

/// A measure of the derivatives up to the second, of the piece before t, and at t.
std::array<double, 2> both_sides(const std::string& scene, double t,
                                 double (*measure)(std::span<const Eigen::Vector3d>)) {
  const BSplineCurve curve = spline_of(in_scene<BSplineCurveObject>(scene));
  std::array<Eigen::Vector3d, 3> before, behind;
  curve.evaluate(just_before(t), before);
  curve.evaluate(t, behind);
  return {measure(before), measure(behind)};
}
std::array<double, 2> curvatures_at(const std::string& scene, double t) { return both_sides(scene, t, curvature); }
std::array<double, 2> speeds_at(const std::string& scene, double t) { return both_sides(scene, t, speed); }

/// K of the torus of the figure, where its second parameter is v.
double torus_curvature(double v) {
  Document document = find_chapter("model-surface")->start_document();
  REQUIRE(apply(document, SetParameter{"model", std::string("torus")}));
  const ModelFigure torus(std::get<ModelSurfaceObject>(stage_shape(document)).model);
  return curvature(torus.evaluate(0.3, v)).gaussian;
}

// --------------------------------------------------------------------------------------------------------------------

std::map<std::string, double> facts() {
  using enum BlendingKind;
  return {
      {"bernstein-3-0", bernstein_at(3, 0, 0.4)},
      {"bernstein-3-1", bernstein_at(3, 1, 0.4)},
      {"bernstein-3-2", bernstein_at(3, 2, 0.4)},
      {"bernstein-3-3", bernstein_at(3, 3, 0.4)},
      {"bernstein-3-1-peak", bernstein_at(3, 1, 1.0 / 3)},
      {"bernstein-10-5-peak", bernstein_at(10, 5, 0.5)},

      {"crowded-knots-distance", distance_from_point_5(uneven_knots())},
      {"even-knots-distance", distance_from_point_5(with_even_knots(uneven_knots()))},
      {"three-rounds-0", three_rounds(0)},
      {"three-rounds-1", three_rounds(1)},
      {"three-rounds-2", three_rounds(2)},
      {"three-rounds-3", three_rounds(3)},

      {"fit-open-6-rms", open_circle(6)},
      {"fit-open-7-rms", open_circle(7)},
      {"fit-open-8-rms", open_circle(8)},
      {"fit-open-11-rms", open_circle(11)},
      {"fit-closed-8-rms", closed_circle(8)},
      {"fit-open-over-closed", open_circle(8) / closed_circle(8)},
      {"pieces-to-the-fourth", std::pow(8.0 / 5, 4)},
      {"condition-20", condition(20)},
      {"condition-normal-20", condition(20) * condition(20)},
      {"noisy-6-rms", noisy_arch(6)},
      {"noisy-7-rms", noisy_arch(7)},
      {"uneven-uniform-rms", uneven_data(DataParameters::uniform)},
      {"uneven-centripetal-rms", uneven_data(DataParameters::centripetal)},
      {"uneven-chord-rms", uneven_data(DataParameters::chord_length)},

      {"subdivision-3-level-0", distance_from_limit(3, 0)},
      {"subdivision-3-level-1", distance_from_limit(3, 1)},
      {"subdivision-3-level-2", distance_from_limit(3, 2)},
      {"subdivision-3-level-3", distance_from_limit(3, 3)},
      {"subdivision-5-ratio-0", ratio_of_levels(5, 0)},
      {"subdivision-5-ratio-4", ratio_of_levels(5, 4)},

      {"comb-before", curvatures_at("bending-comb", 2)[0]},
      {"comb-behind", curvatures_at("bending-comb", 2)[1]},
      {"speed-before", speeds_at("two-speeds", 1)[0]},
      {"speed-behind", speeds_at("two-speeds", 1)[1]},
      {"speed-even", speeds_at("one-speed", 0.8)[1]},
      {"torus-outer", torus_curvature(0)},
      {"torus-inner", torus_curvature(pi)},

      {"corner-top", corner(pulled_circle(linear), 2)},
      {"corner-side", corner(pulled_circle(linear), 1)},
      {"kappa-beyond-knot", curvature_beyond(pulled_circle(polynomial1), 1)},
      {"slope-trigonometric", slope(trigonometric)},
      {"slope-1", slope(polynomial_m, 1)},
      {"slope-2", slope(polynomial_m, 2)},
      {"slope-3", slope(polynomial_m, 3)},
      {"slope-16", slope(polynomial_m, 16)},
      {"slope-expo-rational", slope(expo_rational)},
      {"bend-1", largest_bend(polynomial_m, 1)},
      {"bend-2", largest_bend(polynomial_m, 2)},
      {"bend-3", largest_bend(polynomial_m, 3)},
      {"bend-16", largest_bend(polynomial_m, 16)},
      {"bend-expo-rational", largest_bend(expo_rational)},
      {"expo-rational-at-005", blending(expo_rational, 0, 0.05, 0)},
      {"cubic-at-005", blending(polynomial1, 0, 0.05, 0)},

      {"model-lines-10", distance_from_model(1, 10)},
      {"model-lines-20", distance_from_model(1, 20)},
      {"model-lines-40", distance_from_model(1, 40)},
      {"model-cubics-10", distance_from_model(3, 10)},
      {"model-cubics-20", distance_from_model(3, 20)},
      {"model-cubics-40", distance_from_model(3, 40)},
      {"elbow-speed", elbow_speed()},

      {"net-weight", net_weight()},
      {"hexagon-least", hexagon_radius(-1)},
      {"hexagon-greatest", hexagon_radius(1)},
      {"normal-without-slope", normal_without_slope()},
  };
}

/// A fact as a chapter has it.
struct Stated {
  std::string text, name, file;
};

std::vector<Stated> stated_in_chapters() {
  constexpr std::string_view mark = "](fact:";
  std::vector<Stated> all;
  for (const auto& entry : std::filesystem::directory_iterator(shell_folder / "chapters")) {
    if (entry.path().extension() != ".md") continue;
    const std::string prose = text_of(entry.path());
    for (std::size_t at = prose.find(mark); at != std::string::npos; at = prose.find(mark, at + 1)) {
      const std::size_t open = prose.rfind('[', at) + 1, name = at + mark.size();
      all.push_back({prose.substr(open, at - open), prose.substr(name, prose.find(')', name) - name),
                     entry.path().filename().string()});
    }
  }
  return all;
}

/// Whether the text is this number, rounded to the digits that it has.
bool says(std::string text, double number) {
  constexpr std::string_view minus = "−";
  if (text.starts_with(minus)) text.replace(0, minus.size(), "-");
  char* end = nullptr;
  const double printed = std::strtod(text.c_str(), &end);
  if (text.empty() || text.find_first_not_of("-.0123456789") != std::string::npos || *end != '\0') return false;
  const std::size_t point = text.find('.');
  const double decimals = point == std::string::npos ? 0 : static_cast<double>(text.size() - point - 1);
  return std::abs(printed - number) <= (0.5 + 1e-6) * std::pow(10, -decimals);
}

}  // namespace

TEST_CASE("a printed number is right to half a unit of its last digit") {
  CHECK(says("0.432", 0.43249));
  CHECK_FALSE(says("0.432", 0.43251));
  CHECK(says("1253", 1253.4));
  CHECK(says("−2.44", -2.4361));
  CHECK_FALSE(says("2.44", -2.4361));
  for (const char* text : {"", "−", "nan", "1e0", "0.4x", "1,0", " 1"}) CHECK_FALSE(says(text, 1));
}

TEST_CASE("the chapters' numbers are those of the library, and every one is stated somewhere") {
  const std::map<std::string, double> computed = facts();
  const std::vector<Stated> stated = stated_in_chapters();
  std::set<std::string> unused;
  for (const auto& [name, number] : computed) unused.insert(name);
  for (const Stated& fact : stated) {
    CAPTURE(fact.file);
    CAPTURE(fact.name);
    const auto found = computed.find(fact.name);
    if (found == computed.end()) {
      FAIL_CHECK("no such fact");
      continue;
    }
    CHECK_MESSAGE(says(fact.text, found->second), "the chapter says ", fact.text, ", and it is ", found->second);
    unused.erase(fact.name);
  }
  for (const std::string& name : unused) FAIL_CHECK("no chapter states ", name);
}

}  // namespace knotwork::scene::facts_test
