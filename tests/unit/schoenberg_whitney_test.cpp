#include "knotwork/curve/schoenberg_whitney.h"

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <Eigen/QR>

#include "knotwork/basis/bspline_basis.h"

namespace knotwork::schoenberg_whitney_test {
namespace {

std::vector<double> different(std::vector<double> parameters) {
  std::sort(parameters.begin(), parameters.end());
  parameters.erase(std::unique(parameters.begin(), parameters.end()), parameters.end());
  return parameters;
}

ParameterCount count_of(const KnotVector& knots, const std::vector<double>& parameters) {
  const std::size_t spans = static_cast<std::size_t>(knots.interval_count());
  ParameterCount count{std::vector<int>(spans + (knots.closed() ? 0 : 1)), std::vector<int>(spans)};
  for (const double x : different(parameters)) {
    const std::size_t s = static_cast<std::size_t>(knots.span(x) - knots.degree());
    if (x == knots[knots.span(x)]) {
      ++count.on[s];
    } else if (x == knots.end()) {
      ++count.on.back();
    } else {
      ++count.inside[s];
    }
  }
  return count;
}

Status check(const KnotVector& knots, const std::vector<double>& parameters) {
  return check_schoenberg_whitney(knots, count_of(knots, parameters), 0, knots.count() - 1);
}

std::string message(const KnotVector& knots, const std::vector<double>& parameters) {
  const Status status = check(knots, parameters);
  return status ? "no error" : status.error().message.substr(0, status.error().message.find(':'));
}

/// Which function has a value above 0 at which parameter.
Eigen::MatrixXd matrix(const KnotVector& knots, const std::vector<double>& parameters) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(parameters.size()), knots.count());
  std::vector<double> basis(static_cast<std::size_t>(knots.degree()) + 1);
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    const int span = knots.span(parameters[j]);
    bspline_basis(knots, span, parameters[j], 0, basis);
    for (int k = 0; k <= knots.degree(); ++k) {
      a(static_cast<Eigen::Index>(j), (span - knots.degree() + k) % knots.count()) +=
          basis[static_cast<std::size_t>(k)];
    }
  }
  return a;
}

/// The size of the largest matching of functions and parameters, by augmenting paths: slow, and nothing to do with
/// splines.
class Matching {
 public:
  explicit Matching(const Eigen::MatrixXd& a) : a_(a), row_of_(static_cast<std::size_t>(a.cols()), -1) {
    for (Eigen::Index row = 0; row < a.rows(); ++row) {
      std::vector<bool> visited(row_of_.size(), false);
      size_ += augment(row, visited) ? 1 : 0;
    }
  }
  int size() const { return size_; }

 private:
  bool augment(Eigen::Index row, std::vector<bool>& visited) {
    for (std::size_t c = 0; c < row_of_.size(); ++c) {
      if (visited[c] || !(a_(row, static_cast<Eigen::Index>(c)) > 0)) continue;
      visited[c] = true;
      if (row_of_[c] < 0 || augment(row_of_[c], visited)) {
        row_of_[c] = row;
        return true;
      }
    }
    return false;
  }
  const Eigen::MatrixXd& a_;
  std::vector<Eigen::Index> row_of_;
  int size_ = 0;
};

/// Knots at 0, 1, .. 6, some repeated; clamped, half clamped or not.
KnotVector random_open_knots(int degree, std::mt19937& random) {
  std::uniform_int_distribution<int> multiplicity(1, degree), ends(1, degree + 1);
  std::vector<double> knots;
  for (int k = 0; k <= 6; ++k) {
    const int times = k == 0 || k == 6 ? degree + 1 : multiplicity(random) == 1 ? multiplicity(random) : 1;
    knots.insert(knots.end(), static_cast<std::size_t>(times), k);
  }
  // Fewer at the ends, others outside.
  const int first = ends(random), last = ends(random);
  for (int k = 0; k <= degree - first; ++k) knots[static_cast<std::size_t>(k)] = -1 - (degree - first - k);
  for (int k = 0; k <= degree - last; ++k)
    knots[knots.size() - 1 - static_cast<std::size_t>(k)] = 7 + (degree - last - k);
  return KnotVector::make(degree, Topology::open, std::move(knots)).value();
}

}  // namespace

TEST_CASE("open: the conditions hold exactly where a matching does, and exactly where the matrix has full rank") {
  std::mt19937 random(41);
  int met = 0, failed = 0;
  for (int degree = 1; degree <= 4; ++degree) {
    for (int trial = 0; trial < 300; ++trial) {
      const KnotVector knots = random_open_knots(degree, random);
      // Quarters of a knot interval: many parameters stand on knots and at the ends.
      std::uniform_int_distribution<int> quarter(0, 24), extra(-1, 6), gap(0, 24);
      const int hole = gap(random);
      std::vector<double> parameters;
      for (int j = knots.count() + extra(random); j > 0; --j) {
        const int place = quarter(random);
        parameters.push_back((place >= hole && place < hole + 5 ? 0 : place) / 4.0);
      }
      const Eigen::MatrixXd a = matrix(knots, parameters);
      const bool ok = check(knots, parameters).has_value();
      CHECK(ok == (Matching(matrix(knots, different(parameters))).size() == knots.count()));
      Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a);
      qr.setThreshold(1e-12);
      CHECK(ok == (qr.rank() == knots.count()));
      ++(ok ? met : failed);
    }
  }
  CHECK(met > 100);
  CHECK(failed > 100);
}

TEST_CASE("closed: the conditions hold exactly where a matching does") {
  std::mt19937 random(42);
  int met = 0, failed = 0;
  for (int degree = 1; degree <= 5; ++degree) {
    for (int trial = 0; trial < 300; ++trial) {
      std::uniform_int_distribution<int> number(std::max(2, degree), 9), extra(0, 3), gap(0, 5);
      const int count = number(random), hole = gap(random);
      const KnotVector knots = KnotVector::uniform(degree, count, Topology::closed, 0, count).value();
      std::uniform_int_distribution<int> quarter(0, 4 * count - 1);
      std::vector<double> parameters;
      for (int j = count + extra(random); j > 0; --j)
        parameters.push_back(((quarter(random) / (1 + hole) + 7 * hole) % (4 * count)) / 4.0);
      const bool ok = check(knots, parameters).has_value();
      CAPTURE(degree);
      CAPTURE(count);
      CHECK(ok == (Matching(matrix(knots, different(parameters))).size() == count));
      ++(ok ? met : failed);
    }
  }
  CHECK(met > 100);
  CHECK(failed > 100);
}

TEST_CASE("the error names the functions that miss most, round the seam too") {
  const KnotVector open = KnotVector::uniform(2, 7, Topology::open, 0, 5).value();
  CHECK(message(open, {0, 0.5, 1.5, 2.5, 3.5, 4.5, 5}) == "no error");
  CHECK(message(open, {0, 0.5, 0.75, 2.5, 4.25, 4.5, 5}) == "no error");
  CHECK(message(open, {0, 0.5, 0.75, 1, 4.5, 4.75, 5}) == "No data supports the basis function 3");
  CHECK(message(open, {0, 0.25, 0.5, 0.75, 1, 4.75, 5}) == "Only one parameter supports the 3 basis functions 3 to 5");
  CHECK(message(open, {0, 0.5, 1, 1, 1, 4, 4.5, 4.75, 5}) == "No data supports the basis function 3");
  CHECK(message(open, {0, 0.25, 0.5, 0.75, 1, 0.875, 0.125}) == "No data supports the 4 basis functions 3 to 6");
  CHECK(message(open, {0.5, 0.5, 1.5, 2.5, 3.5, 4.5, 5}) ==
        "Only 5 different parameters support the 6 basis functions 0 to 5");
  const KnotVector closed = KnotVector::uniform(2, 7, Topology::closed, 0, 7).value();
  CHECK(message(closed, {0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5}) == "no error");
  CHECK(message(closed, {1.1, 1.2, 1.3, 1.5, 1.6, 2, 2.1}) == "No data supports the 3 basis functions 5 to 0");
  CHECK(message(closed, {0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 5.5}) ==
        "Only 6 different parameters support the 7 basis functions 0 to 6");
}

}  // namespace knotwork::schoenberg_whitney_test
