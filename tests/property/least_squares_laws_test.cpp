// What holds for every least squares fit, against Eigen's dense factorizations where these can say what is right.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "knotwork/basis/bspline_basis.h"
#include "knotwork/curve/least_squares.h"
#include "knotwork/curve/parameterization.h"
#include "unit/oracle.h"

namespace knotwork::least_squares_laws_test {
using namespace test;
namespace {

using Matrix = Eigen::MatrixXd;

/// Knots of random widths, and data that leave nothing undetermined, in random order.
struct Problem {
  KnotVector knots;
  std::vector<double> parameters;
  std::vector<Eigen::Vector3d> points;
};

Eigen::Vector3d random_point(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-5, 5);
  const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
  return {x, y, z};
}

std::vector<Eigen::Vector3d> random_points(int count, std::mt19937& random) {
  std::vector<Eigen::Vector3d> points(static_cast<std::size_t>(count));
  for (Eigen::Vector3d& point : points) point = random_point(random);
  return points;
}

KnotVector random_knots(int degree, int count, Topology topology, std::mt19937& random) {
  std::uniform_real_distribution<double> width(0.3, 1.0);
  const int intervals = topology == Topology::closed ? count : count - degree;
  std::vector<double> at = {1.5};
  for (int k = 0; k < intervals; ++k) at.push_back(at.back() + width(random));
  std::vector<double> knots;
  for (int k = -degree; k <= intervals + degree; ++k) {
    if (topology == Topology::open) {
      knots.push_back(at[static_cast<std::size_t>(std::clamp(k, 0, intervals))]);
    } else {
      const int round = k < 0 ? -1 : k > intervals ? 1 : 0;
      knots.push_back(at[static_cast<std::size_t>(k - round * intervals)] + round * (at.back() - at.front()));
    }
  }
  return KnotVector::make(degree, topology, std::move(knots)).value();
}

Problem random_problem(int degree, int count, Topology topology, std::mt19937& random) {
  Problem problem{random_knots(degree, count, topology, random), {}, {}};
  const KnotVector& knots = problem.knots;
  // Enough in every interval, one more here and there, and some on knots.
  std::uniform_int_distribution<int> more(degree + 1, degree + 4);
  for (int s = degree; s <= knots.last_span(); ++s) {
    std::uniform_real_distribution<double> place(knots[s], knots[s + 1]);
    problem.parameters.push_back(knots[s]);
    for (int k = more(random); k > 0; --k) problem.parameters.push_back(place(random));
  }
  if (topology == Topology::open) problem.parameters.push_back(knots.end());
  std::shuffle(problem.parameters.begin(), problem.parameters.end(), random);
  problem.points = random_points(static_cast<int>(problem.parameters.size()), random);
  return problem;
}

/// visit(problem) for random problems of degree 1 to 9, open and closed, the smallest ones among them.
template <class Visit>
void for_each_problem(unsigned seed, Visit visit) {
  std::mt19937 random(seed);
  for (const Topology topology : {Topology::open, Topology::closed}) {
    for (int degree = 1; degree <= 9; ++degree) {
      const int least = topology == Topology::closed ? std::max(2, degree) : degree + 1;
      for (const int count : {least, least + 1, least + 3, 2 * degree, 2 * degree + 1, 30}) {
        if (count < least) continue;
        CAPTURE(degree);
        CAPTURE(count);
        visit(random_problem(degree, count, topology, random), random);
      }
    }
  }
}

LeastSquaresFit fit(const Problem& problem, const LeastSquaresOptions& options = {}) {
  return fit_least_squares(problem.knots, problem.points, problem.parameters, options).value();
}

Matrix matrix(const KnotVector& knots, const std::vector<double>& parameters) {
  Matrix a = Matrix::Zero(static_cast<Eigen::Index>(parameters.size()), knots.count());
  std::vector<double> basis(static_cast<std::size_t>(knots.degree()) + 1);
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    const double t = knots.reduced(parameters[j]);
    const int span = knots.span(t);
    bspline_basis(knots, span, t, 0, basis);
    for (int k = 0; k <= knots.degree(); ++k)
      a(static_cast<Eigen::Index>(j), (span - knots.degree() + k) % knots.count()) +=
          basis[static_cast<std::size_t>(k)];
  }
  return a;
}

Matrix matrix(const std::vector<Eigen::Vector3d>& points) {
  Matrix b(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t j = 0; j < points.size(); ++j) b.row(static_cast<Eigen::Index>(j)) = points[j].transpose();
  return b;
}

Matrix control_points(const LeastSquaresFit& result) {
  return matrix({result.curve.points().begin(), result.curve.points().end()});
}

/// The second differences over the Greville abscissae, as least_squares.h defines them.
Matrix penalty(const KnotVector& knots) {
  const int n = knots.count(), p = knots.degree();
  const auto greville = [&](int i) {
    double sum = 0;
    for (int k = 1; k <= p; ++k) sum += knots[i + k];
    return sum / p;
  };
  Matrix rows = Matrix::Zero(knots.closed() ? n : n - 2, n);
  for (int i = 1; i <= rows.rows(); ++i) {
    const double before = greville(i) - greville(i - 1);
    const double behind = greville(i + 1) - greville(i);
    const double share = before / (before + behind);
    rows(i - 1, i - 1) += 2 * (1 - share);
    rows(i - 1, i % n) -= 2;
    rows(i - 1, (i + 1) % n) += 2 * share;
  }
  return rows;
}

Matrix stacked(const Matrix& above, const Matrix& below) {
  Matrix both(above.rows() + below.rows(), above.cols());
  both << above, below;
  return both;
}

Matrix dense_solution(const Matrix& a, const Matrix& b) { return a.colPivHouseholderQr().solve(b); }

/// The condition number, as well as a pivoted triangle shows it.
double condition(const Matrix& a) {
  const Eigen::ColPivHouseholderQR<Matrix> qr(a);
  return qr.maxPivot() / std::abs(qr.matrixR()(a.cols() - 1, a.cols() - 1));
}

/// As good as rounding lets it be.
void check_same(const Matrix& actual, const Matrix& expected, double condition_number) {
  const double bound = 1e-14 * (1 + condition_number) * (1 + expected.cwiseAbs().maxCoeff());
  CHECK(closeness((actual - expected).cwiseAbs().maxCoeff(), bound));
}

}  // namespace

TEST_CASE("a spline on whose curve the data lie is found again") {
  for_each_problem(1, [](Problem problem, std::mt19937& random) {
    const std::vector<Eigen::Vector3d> points = random_points(problem.knots.count(), random);
    const BSplineCurve curve = BSplineCurve::make(problem.knots, points).value();
    for (std::size_t j = 0; j < problem.points.size(); ++j) problem.points[j] = curve(problem.parameters[j]);
    const LeastSquaresFit result = fit(problem);
    check_same(control_points(result), matrix(points), condition(matrix(problem.knots, problem.parameters)));
    CHECK(result.maximum < 1e-13);
  });
}

TEST_CASE("control points, residuals and norms are those of dense QR") {
  for_each_problem(2, [](const Problem& problem, std::mt19937&) {
    const Matrix a = matrix(problem.knots, problem.parameters), b = matrix(problem.points);
    const LeastSquaresFit result = fit(problem);
    const Matrix expected = dense_solution(a, b);
    check_same(control_points(result), expected, condition(a));
    const Eigen::VectorXd residuals = (a * expected - b).rowwise().norm();
    REQUIRE(static_cast<Eigen::Index>(result.residuals.size()) == residuals.size());
    for (std::size_t j = 0; j < result.residuals.size(); ++j)
      CHECK(close(result.residuals[j], residuals(static_cast<Eigen::Index>(j)), 1e-12, 5));
    CHECK(close(result.maximum, residuals.maxCoeff(), 1e-12));
    CHECK(close(result.rms, std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.size())), 1e-12));
  });
}

TEST_CASE("what is left is orthogonal to every basis function") {
  for_each_problem(3, [](const Problem& problem, std::mt19937&) {
    const Matrix a = matrix(problem.knots, problem.parameters);
    const Matrix left = a.transpose() * (a * control_points(fit(problem)) - matrix(problem.points));
    CHECK(left.cwiseAbs().maxCoeff() < 1e-12 * 5);
  });
}

TEST_CASE("with interpolated ends the others are the dense solution of what remains") {
  for_each_problem(4, [](const Problem& problem, std::mt19937&) {
    if (problem.knots.closed() || problem.knots.count() < 3) return;
    const Matrix a = matrix(problem.knots, problem.parameters), b = matrix(problem.points);
    const LeastSquaresFit result = fit(problem, {.interpolate_ends = true});
    const Eigen::Index n = a.cols();
    const Matrix rest = b - a.col(0) * b.row(0) - a.col(n - 1) * b.row(b.rows() - 1);
    const Matrix inner = a.middleCols(1, n - 2);
    const Matrix actual = control_points(result);
    check_same(actual.middleRows(1, n - 2), dense_solution(inner, rest), condition(inner));
    CHECK(actual.row(0) == b.row(0));
    CHECK(actual.row(n - 1) == b.row(b.rows() - 1));
    // The same with a penalty, whose rows know the ends as well.
    const Matrix d = penalty(problem.knots);
    const Matrix all = stacked(a, d), right = stacked(b, Matrix::Zero(d.rows(), 3));
    const Matrix smooth_rest = right - all.col(0) * b.row(0) - all.col(n - 1) * b.row(b.rows() - 1);
    const LeastSquaresFit smoothed = fit(problem, {.interpolate_ends = true, .smoothing = 1});
    check_same(control_points(smoothed).middleRows(1, n - 2), dense_solution(all.middleCols(1, n - 2), smooth_rest),
               condition(all.middleCols(1, n - 2)));
  });
}

TEST_CASE("smoothing is the dense solution with the penalty's rows, with fewer points than control points too") {
  for_each_problem(5, [](Problem problem, std::mt19937&) {
    if (problem.knots.count() < 3) return;
    for (const double smoothing : {1e-4, 1.0, 1e6}) {
      for (const std::size_t size : {problem.points.size(), static_cast<std::size_t>(problem.knots.count() / 2 + 1)}) {
        problem.points.resize(size);
        problem.parameters.resize(size);
        const Matrix d = std::sqrt(smoothing) * penalty(problem.knots);
        const Matrix a = stacked(matrix(problem.knots, problem.parameters), d);
        const Matrix b = stacked(matrix(problem.points), Matrix::Zero(d.rows(), 3));
        check_same(control_points(fit(problem, {.smoothing = smoothing})), dense_solution(a, b), condition(a));
      }
    }
  });
}

TEST_CASE("straight lines cost nothing, and much smoothing leads to them; closed, to a point") {
  for_each_problem(6, [](Problem problem, std::mt19937&) {
    const double size = static_cast<double>(problem.points.size());
    const LeastSquaresFit stiff = fit(problem, {.smoothing = 1e10});
    if (problem.knots.closed()) {
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (const Eigen::Vector3d& point : problem.points) mean += point / size;
      for (const Eigen::Vector3d& point : stiff.curve.points()) CHECK(close(point, mean, 1e-7, 5));
      return;
    }
    if (problem.knots.count() < 3) return;
    Matrix a(static_cast<Eigen::Index>(problem.points.size()), 2);
    for (Eigen::Index j = 0; j < a.rows(); ++j) a.row(j) << 1, problem.parameters[static_cast<std::size_t>(j)];
    const Matrix line = dense_solution(a, matrix(problem.points));
    const auto at = [&](double t) -> Eigen::Vector3d { return (line.row(0) + t * line.row(1)).transpose(); };
    for (const double share : {0.0, 0.3, 1.0}) {
      const double t = std::lerp(problem.knots.start(), problem.knots.end(), share);
      CHECK(close(stiff.curve(t), at(t), 1e-6, 5));
    }
    for (std::size_t j = 0; j < problem.points.size(); ++j) problem.points[j] = at(problem.parameters[j]);
    for (const double smoothing : {1e-3, 1.0, 1e3}) CHECK(fit(problem, {.smoothing = smoothing}).maximum < 1e-11);
  });
}

TEST_CASE("an affine image of the data has the affine image of the curve") {
  for_each_problem(7, [](Problem problem, std::mt19937& random) {
    const Matrix before = control_points(fit(problem));
    Eigen::Matrix3d linear;
    linear << random_point(random), random_point(random), random_point(random);
    const Eigen::Vector3d shift = 100 * random_point(random);
    for (Eigen::Vector3d& point : problem.points) point = linear * point + shift;
    const Matrix expected = (before * linear.transpose()).rowwise() + shift.transpose();
    check_same(control_points(fit(problem)), expected, condition(matrix(problem.knots, problem.parameters)));
  });
}

TEST_CASE("the order of the data does not matter, nor on which round of a closed curve a parameter is") {
  for_each_problem(8, [](const Problem& problem, std::mt19937& random) {
    const LeastSquaresFit before = fit(problem);
    std::vector<std::size_t> order(problem.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return problem.parameters[i] < problem.parameters[j]; });
    std::uniform_int_distribution<int> round(-1, 2);
    Problem sorted{problem.knots, {}, {}};
    for (const std::size_t j : order) {
      const double turn = problem.knots.closed() ? round(random) * problem.knots.period() : 0;
      sorted.parameters.push_back(problem.parameters[j] + turn);
      sorted.points.push_back(problem.points[j]);
    }
    const LeastSquaresFit after = fit(sorted);
    check_same(control_points(after), control_points(before), condition(matrix(problem.knots, problem.parameters)));
    for (std::size_t k = 0; k < order.size(); ++k)
      CHECK(close(after.residuals[k], before.residuals[order[k]], 1e-10, 5));
  });
}

TEST_CASE("a weight is worth so many equal points") {
  for_each_problem(9, [](const Problem& problem, std::mt19937& random) {
    std::uniform_int_distribution<int> times(1, 4);
    Problem repeated{problem.knots, {}, {}};
    std::vector<double> weights;
    for (std::size_t j = 0; j < problem.points.size(); ++j) {
      weights.push_back(times(random));
      for (int k = 0; k < weights.back(); ++k) {
        repeated.parameters.push_back(problem.parameters[j]);
        repeated.points.push_back(problem.points[j]);
      }
    }
    const LeastSquaresFit weighted = fit(problem, {.weights = weights}), equal = fit(repeated);
    check_same(control_points(weighted), control_points(equal), condition(matrix(problem.knots, problem.parameters)));
    CHECK(close(weighted.rms, equal.rms, 1e-12));
    CHECK(close(weighted.maximum, equal.maximum, 1e-10));
  });
}

TEST_CASE("only the ratios of weights count") {
  for_each_problem(13, [](const Problem& problem, std::mt19937&) {
    const bool ends = !problem.knots.closed();
    const LeastSquaresFit plain = fit(problem, {.interpolate_ends = ends});
    for (const double weight : {1e-40, 1e40}) {
      const std::vector<double> weights(problem.points.size(), weight);
      const LeastSquaresFit weighted = fit(problem, {.interpolate_ends = ends, .weights = weights});
      check_same(control_points(weighted), control_points(plain), condition(matrix(problem.knots, problem.parameters)));
      CHECK(close(weighted.rms, plain.rms, 1e-12));
    }
  });
}

TEST_CASE("a closed curve has no seam: data that start elsewhere turn the control points") {
  std::mt19937 random(10);
  for (int degree = 1; degree <= 9; ++degree) {
    const int count = 14;
    const KnotVector knots = KnotVector::uniform(degree, count, Topology::closed, 0, count).value();
    std::uniform_real_distribution<double> place(0, count);
    Problem problem{knots, {}, {}};
    for (int j = 0; j < 200; ++j) {
      problem.parameters.push_back(place(random));
      problem.points.push_back(random_point(random));
    }
    const LeastSquaresFit before = fit(problem);
    for (const int turn : {1, 5, 13}) {
      Problem turned = problem;
      for (double& x : turned.parameters) x += turn;
      const LeastSquaresFit after = fit(turned);
      for (int i = 0; i < count; ++i)
        CHECK(close(after.curve.point(i + turn), before.curve.point(i),
                    1e-13 * condition(matrix(knots, problem.parameters)), 5));
    }
  }
}

TEST_CASE("data in bad places: no digits are lost that normal equations lose") {
  // The middle third of a polynomial of degree 9 says little about its ends.
  const KnotVector knots = KnotVector::uniform(9, 10, Topology::open, 0, 3).value();
  std::mt19937 random(11);
  Problem problem{knots, {}, {}};
  const std::vector<Eigen::Vector3d> truth = random_points(10, random);
  const BSplineCurve curve = BSplineCurve::make(knots, truth).value();
  for (int j = 0; j <= 90; ++j) {
    problem.parameters.push_back(1 + j / 90.0);
    problem.points.push_back(curve(problem.parameters.back()));
  }
  const Matrix a = matrix(knots, problem.parameters), b = matrix(problem.points);
  const double number = condition(a);
  CHECK(number > 1e5);

  const auto error = [&](const Matrix& solution) { return (solution - matrix(truth)).cwiseAbs().maxCoeff(); };
  const double banded = error(control_points(fit(problem)));
  const double dense = error(dense_solution(a, b));
  const double normal = error((a.transpose() * a).ldlt().solve(a.transpose() * b));
  CAPTURE(number);
  CAPTURE(banded);
  CAPTURE(dense);
  CAPTURE(normal);
  CHECK(banded < 1e-14 * number);
  CHECK(banded < 10 * dense + 1e-14);
  CHECK(normal > 1e3 * banded);
}

TEST_CASE("closed data that determine nothing, although every function has its own, are refused") {
  for (int degree = 1; degree <= 9; ++degree) {
    for (const int count : {9, 10, 11, 12, 400, 401}) {
      const KnotVector knots = KnotVector::uniform(degree, count, Topology::closed, 0, count).value();
      Problem on_knots{knots, {}, {}}, between{knots, {}, {}};
      for (int j = 0; j < count; ++j) {
        on_knots.parameters.push_back(j);
        between.parameters.push_back(j + 0.5);
        on_knots.points.emplace_back(std::cos(j), std::sin(2 * j), 1);
      }
      between.points = on_knots.points;
      CAPTURE(degree);
      CAPTURE(count);
      // The mask of the values at the knots (at the middles) is symmetric and has a zero at -1 where it is even.
      for (const Problem* problem : {&on_knots, &between}) {
        const bool singular = count % 2 == 0 && degree % 2 == (problem == &on_knots ? 0 : 1);
        const Result<LeastSquaresFit> result =
            fit_least_squares(knots, problem->points, problem->parameters, LeastSquaresOptions{});
        CHECK(result.has_value() == !singular);
        if (singular) {
          CHECK(result.error().path == "parameters");
          CHECK(result.error().message.find("The data determine control point") == 0);
          CHECK(fit_least_squares(knots, problem->points, problem->parameters, {.smoothing = 1e-6}));
        } else {
          CHECK(result.value().maximum < 1e-10);
        }
      }
    }
  }
}

TEST_CASE("curves through points on averaged knots exist and pass them, open and closed") {
  std::mt19937 random(12);
  for (const Topology topology : {Topology::open, Topology::closed}) {
    for (int degree = 1; degree <= 5; ++degree) {
      for (const int count : {8, 11, 40}) {
        std::vector<Eigen::Vector3d> points = random_points(count, random);
        for (int j = 0; j < count; ++j) points[static_cast<std::size_t>(j)].x() = j;
        for (const double exponent : {0.0, 0.5, 1.0}) {
          const std::vector<double> parameters = parameterize(points, exponent, topology, 0, 1).value();
          const KnotVector knots = averaged_knots(degree, count, topology, parameters, 1).value();
          const Result<LeastSquaresFit> result = fit_least_squares(knots, points, parameters);
          CAPTURE(degree);
          CAPTURE(count);
          REQUIRE(result);
          CHECK(result.value().maximum < 1e-10);
          for (std::size_t j = 0; j < points.size(); ++j)
            CHECK(close(result.value().curve(parameters[j]), points[j], 1e-10, 5));
        }
      }
    }
  }
}

}  // namespace knotwork::least_squares_laws_test
