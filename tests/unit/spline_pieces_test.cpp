#include "knotwork/curve/spline_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "unit/bspline_cases.h"

namespace knotwork::spline_pieces_test {
using namespace test;
namespace {

/// The error bound that the header states.
constexpr double stated = 1e-13;

/// The largest |D^k c| that points of this size can have at t.
double bound_at(const BSplineCurve& curve, double t, std::size_t k) {
  return basis_size(curve.knots(), t, static_cast<int>(k)) * polygon_size(curve);
}

/// Parameters inside, outside, at knots and next to them, sorted.
std::vector<double> parameters(const BSplineCurve& curve, std::mt19937& random) {
  const KnotVector& knots = curve.knots();
  std::uniform_real_distribution<double> place(knots.start() - 0.2 * knots.period(),
                                               knots.end() + 0.2 * knots.period());
  std::vector<double> t;
  t.reserve(40 + 2 * knots.knots().size());
  for (int k = 0; k < 40; ++k) t.push_back(place(random));
  for (const double knot : knots.knots()) {
    t.push_back(knot);
    t.push_back(std::nextafter(knot, -1e9));
  }
  std::sort(t.begin(), t.end());
  return t;
}

/// Fifty in each piece, its ends among them, sorted: whole blocks lie in one piece and are evaluated together.
std::vector<double> crowded_parameters(const KnotVector& knots, std::mt19937& random) {
  constexpr std::size_t each = 50;
  std::vector<double> t;
  t.reserve(each * knots.knots().size());
  for (int span = knots.degree(); span <= knots.last_span(); ++span) {
    const double from = knots[span], to = knots[span + 1];
    if (!(from < to)) continue;
    std::uniform_real_distribution<double> place(from, to);
    t.push_back(from);
    t.push_back(std::nextafter(to, from));
    for (std::size_t k = 2; k < each; ++k) t.push_back(place(random));
  }
  std::sort(t.begin(), t.end());
  return t;
}

/// All values in one batch; the largest error in terms of the stated bound.
double worst_error(const BSplineCurve& curve, const std::vector<double>& t, int order) {
  const SplinePieces pieces(curve);
  const std::size_t values = static_cast<std::size_t>(order) + 1;
  std::vector<Eigen::Vector3d> actual(t.size() * values), expected(values);
  pieces.evaluate(t, order, actual);
  double worst = 0;
  for (std::size_t m = 0; m < t.size(); ++m) {
    curve.evaluate(t[m], expected);
    for (std::size_t k = 0; k < values; ++k) {
      const double bound = stated * bound_at(curve, t[m], k);
      const double error = (actual[m * values + k] - expected[k]).norm();
      worst = std::max(worst, bound > 0 ? error / bound : (error > 0 ? 1e9 : 0));
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("the pieces meet oracles 01 and 02") {
  int compared = 0;
  for (const Topology topology : {Topology::open, Topology::closed}) {
    for (const CurveOracle& oracle : curve_oracles(topology)) {
      const SplinePieces pieces(oracle.curve);
      CAPTURE(oracle.name);
      for (const nlohmann::json& at : oracle.points) {
        const double t = at["t"].get<double>();
        if (topology == Topology::closed && t >= oracle.curve.knots().end()) continue;
        Eigen::Vector3d out[SplinePieces::max_order + 1];
        pieces.evaluate({&t, 1}, SplinePieces::max_order, out);
        for (std::size_t k = 0; k < std::min<std::size_t>(3, at["derivatives"].size()); ++k, ++compared) {
          CHECK(close(out[k], vector3(at["derivatives"][k]), oracle_tolerance, bound_at(oracle.curve, t, k)));
        }
        CHECK(pieces(t) == out[0]);
      }
    }
  }
  CHECK(compared > 600);
}

TEST_CASE("at every degree, sorted or not, inside, outside and at knots, the pieces are the curve") {
  std::mt19937 random(41);
  double worst = 0;
  for (const Ends ends : {Ends::clamped, Ends::unclamped, Ends::closed}) {
    for (int degree = 1; degree <= KnotVector::max_degree; ++degree) {
      const BSplineCurve curve = random_curve(degree, degree + 6, ends, random);
      std::vector<double> t = parameters(curve, random);
      CAPTURE(degree);
      CHECK(worst_error(curve, t, 2) < 1);
      std::shuffle(t.begin(), t.end(), random);
      worst = std::max(worst, worst_error(curve, t, degree % 2));
    }
  }
  CHECK(worst < 0.2);  // 0.02 was measured
}

TEST_CASE("many parameters in each piece, which are evaluated together: the pieces are the curve") {
  std::mt19937 random(44);
  double worst = 0;
  for (const Ends ends : {Ends::clamped, Ends::unclamped, Ends::closed}) {
    // 1 to 5 have code of their own, the others share theirs.
    for (int degree = 1; degree <= 6; ++degree) {
      const BSplineCurve curve = random_curve(degree, degree + 6, ends, random);
      const std::vector<double> t = crowded_parameters(curve.knots(), random);
      for (int order = 0; order <= SplinePieces::max_order; ++order) {
        CAPTURE(degree);
        CAPTURE(order);
        const double error = worst_error(curve, t, order);
        CHECK(error < 1);
        worst = std::max(worst, error);
      }
    }
  }
  CHECK(worst < 0.2);
}

TEST_CASE("the comparison with the curve sees a point that is off by 1e-11") {
  std::mt19937 random(42);
  const BSplineCurve curve = random_curve(3, 8, Ends::clamped, random);
  const SplinePieces pieces(curve);
  std::vector<Eigen::Vector3d> moved(curve.points().begin(), curve.points().end());
  moved[4].y() += 1e-11;
  const BSplineCurve other = BSplineCurve::make(curve.knots(), moved).value();
  double worst = 0;
  for (const double t : parameters(curve, random)) worst = std::max(worst, (pieces(t) - other(t)).norm());
  CHECK(worst > stated * polygon_size(curve));
}

TEST_CASE("many knots close together: a search among them, with the same outcome") {
  std::mt19937 random(43);
  std::vector<double> knots{0, 0, 0, 0};
  for (int k = 40; k > 0; --k) knots.push_back(std::ldexp(1.0, -k));
  knots.insert(knots.end(), 4, 1.0);
  const KnotVector vector = KnotVector::make(3, Topology::open, std::move(knots)).value();
  const BSplineCurve curve = BSplineCurve::make(vector, random_points(44, random)).value();
  CHECK(SplinePieces(curve).piece_count() == 41);
  std::vector<double> t = parameters(curve, random);
  for (int k = 1; k < 45; ++k) t.push_back(1.5 * std::ldexp(1.0, -k));
  for (const int order : {0, 2}) CHECK(worst_error(curve, t, order) < 1);
  std::sort(t.begin(), t.end());
  for (const int order : {0, 2}) CHECK(worst_error(curve, t, order) < 1);
}

TEST_CASE("at a knot the piece on its right counts, at an open end the last one") {
  const KnotVector knots = KnotVector::make(1, Topology::open, {0, 0, 1, 2, 2}).value();
  const SplinePieces pieces(BSplineCurve::make(knots, {{0, 0, 0}, {1, 0, 0}, {1, 5, 0}}).value());
  const std::vector<double> t{-1, 0, 1, 2, 3};
  std::vector<Eigen::Vector3d> out(3 * t.size());
  pieces.evaluate(t, 2, out);
  const Eigen::Vector3d slopes[] = {{1, 0, 0}, {1, 0, 0}, {0, 5, 0}, {0, 5, 0}, {0, 5, 0}};
  for (std::size_t m = 0; m < t.size(); ++m) {
    CHECK(out[3 * m + 1] == slopes[m]);
    CHECK(out[3 * m + 2] == Eigen::Vector3d::Zero());  // above the degree
  }
  CHECK(out[3 * 4] == Eigen::Vector3d(1, 5, 0));
}

}  // namespace knotwork::spline_pieces_test
