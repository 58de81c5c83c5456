#include "knotwork/basis/knot_vector.h"

#include <cmath>
#include <limits>
#include <string>

#include <doctest/doctest.h>

namespace knotwork::knot_vector_test {
namespace {

std::vector<double> list(const KnotVector& knots) { return {knots.knots().begin(), knots.knots().end()}; }

KnotVector uniform(int degree, int count, Topology topology, double start, double end) {
  return KnotVector::uniform(degree, count, topology, start, end).value();
}

std::string error_path(const Result<KnotVector>& result) {
  return result.has_value() ? "no error" : result.error().path;
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("uniform open knots are clamped (THEORY 2.2, 2.7)") {
  CHECK(list(uniform(1, 4, Topology::open, 0, 3)) == std::vector<double>{0, 0, 1, 2, 3, 3});
  CHECK(list(uniform(3, 5, Topology::open, 0, 2)) == std::vector<double>{0, 0, 0, 0, 1, 2, 2, 2, 2});
  CHECK(list(uniform(1, 2, Topology::open, -1, 1)) == std::vector<double>{-1, -1, 1, 1});
}

TEST_CASE("uniform closed knots go on periodically at both ends (THEORY 2.2, 2.7)") {
  CHECK(list(uniform(1, 4, Topology::closed, 0, 4)) == std::vector<double>{-1, 0, 1, 2, 3, 4, 5});
  CHECK(list(uniform(2, 3, Topology::closed, 2, 5)) == std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7});
}

TEST_CASE("domain, counts and spans of open and closed knots") {
  const KnotVector open = uniform(3, 7, Topology::open, 0, 4);
  CHECK(open.count() == 7);
  CHECK(open.start() == 0);
  CHECK(open.end() == 4);
  CHECK(open.interval_count() == 4);
  CHECK(open.last_span() == 6);
  CHECK_FALSE(open.closed());

  const KnotVector closed = uniform(1, 5, Topology::closed, -1, 1);
  CHECK(closed.count() == 5);
  CHECK(closed.start() == -1);
  CHECK(closed.end() == 1);
  CHECK(closed.period() == 2);
  CHECK(closed.interval_count() == 5);
  CHECK(closed.last_span() == 5);
  CHECK(closed.closed());
}

TEST_CASE("the domain's ends are exact whatever the rounding of the steps") {
  for (const int n : {2, 3, 7, 10, 49, 4096}) {
    for (const Topology topology : {Topology::open, Topology::closed}) {
      const KnotVector knots = uniform(1, n, topology, -0.1, 0.7);
      CHECK(knots.start() == -0.1);
      CHECK(knots.end() == 0.7);
    }
  }
}

TEST_CASE("uniform refuses what cannot be a knot vector") {
  using K = KnotVector;
  CHECK(error_path(K::uniform(0, 4, Topology::open, 0, 1)) == "degree");
  CHECK(error_path(K::uniform(17, 40, Topology::open, 0, 1)) == "degree");
  CHECK(error_path(K::uniform(1, 1, Topology::open, 0, 1)) == "count");
  CHECK(error_path(K::uniform(3, 3, Topology::open, 0, 1)) == "count");
  CHECK(error_path(K::uniform(1, 1, Topology::closed, 0, 1)) == "count");
  CHECK(error_path(K::uniform(4, 3, Topology::closed, 0, 1)) == "count");
  CHECK(error_path(K::uniform(1, 0, Topology::open, 0, 1)) == "count");
  CHECK(error_path(K::uniform(1, -5, Topology::closed, 0, 1)) == "count");
  CHECK(error_path(K::uniform(1, 1000000000, Topology::closed, 0, 1)) == "count");
  CHECK(error_path(K::uniform(1, 4, Topology::open, not_a_number, 1)) == "start");
  CHECK(error_path(K::uniform(1, 4, Topology::open, -inf, 1)) == "start");
  CHECK(error_path(K::uniform(1, 4, Topology::open, 0, inf)) == "end");
  CHECK(error_path(K::uniform(1, 4, Topology::open, -1e308, 1e308)) == "start");
  CHECK(error_path(K::uniform(1, 4, Topology::open, 1, 1)) == "end");
  CHECK(error_path(K::uniform(1, 4, Topology::open, 2, 1)) == "end");
  CHECK(error_path(K::uniform(1, 10, Topology::open, 1, std::nextafter(1.0, 2.0))).starts_with("knots["));
}

TEST_CASE("make takes knots as given and names the knot that is wrong") {
  const auto path = [](int degree, Topology topology, std::vector<double> knots) {
    return error_path(KnotVector::make(degree, topology, std::move(knots)));
  };
  CHECK(path(1, Topology::open, {0, 0, 0.3, 1, 1}) == "no error");
  CHECK(path(2, Topology::open, {0, 0, 0, 0.5, 0.5, 1, 1, 1}) == "no error");
  CHECK(path(2, Topology::open, {0, 1, 2, 3, 4, 5}) == "no error");
  CHECK(path(1, Topology::closed, {-0.7, 0, 0.3, 1, 1.3}) == "no error");

  CHECK(path(0, Topology::open, {0, 1, 2}) == "degree");
  CHECK(path(17, Topology::open, {0, 1, 2}) == "degree");
  CHECK(path(1, Topology::open, {0, 0, 1}) == "count");
  CHECK(path(1, Topology::closed, {0, 1, 2, 3}) == "count");
  CHECK(path(1, Topology::open, {}) == "count");
  CHECK(path(1, Topology::open, std::vector<double>(KnotVector::max_count + 10, 0.0)) == "count");
  CHECK(path(1, Topology::open, {0, 0, not_a_number, 1, 1}) == "knots[2]");
  CHECK(path(1, Topology::open, {0, 0, 1, inf, inf}) == "knots[3]");
  CHECK(path(1, Topology::open, {0, 0, 0.5, 0.4, 1, 1}) == "knots[3]");
  CHECK(path(1, Topology::open, {0, 0, 0.5, 0.5, 1, 1}) == "knots[3]");
  CHECK(path(1, Topology::open, {0, 0, 0, 1, 1}) == "knots[2]");
  CHECK(path(2, Topology::open, {0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1}) == "knots[5]");
  CHECK(path(1, Topology::closed, {-0.7, 0, 0.3, 1, 1.4}) == "knots[4]");
  CHECK(path(1, Topology::closed, {-0.7, 0, 0, 0.3, 1, 1}) == "knots[2]");
  CHECK(path(1, Topology::open, {1, 1, 1, 1}) == "knots[2]");
}

TEST_CASE("an error says a sentence") {
  const Result<KnotVector> result = KnotVector::make(1, Topology::open, {0, 0, 0.5, 0.4, 1, 1});
  REQUIRE_FALSE(result.has_value());
  CHECK(result.error().message == "The knots must not decrease.");
}

TEST_CASE("reduced clamps open parameters and wraps closed ones") {
  const KnotVector open = uniform(1, 3, Topology::open, 1, 3);
  CHECK(open.reduced(0.5) == 1);
  CHECK(open.reduced(1.25) == 1.25);
  CHECK(open.reduced(3) == 3);
  CHECK(open.reduced(1e300) == 3);

  const KnotVector closed = uniform(1, 4, Topology::closed, 1, 3);
  CHECK(closed.reduced(1) == 1);
  CHECK(closed.reduced(2.75) == 2.75);
  CHECK(closed.reduced(3) == 1);
  CHECK(closed.reduced(3.5) == 1.5);
  CHECK(closed.reduced(0.5) == 2.5);
  CHECK(closed.reduced(-3) == 1);
  CHECK(closed.reduced(1 + 2e6) == 1);
  CHECK(closed.reduced(std::nextafter(1.0, 0.0)) < 3);
}

TEST_CASE("reduced stays in the domain however far the parameter is") {
  const KnotVector closed = uniform(1, 3, Topology::closed, -0.3, 0.4);
  for (const double t : {1e300, -1e300, 1e-300, -0.3 - 1e-18, 0.4, 12345.678, -98765.4321}) {
    const double r = closed.reduced(t);
    CHECK(r >= closed.start());
    CHECK(r < closed.end());
  }
}

TEST_CASE("the span is the half-open interval that holds the parameter") {
  const KnotVector knots = KnotVector::make(2, Topology::open, {0, 0, 0, 1, 1, 2, 4, 4, 4}).value();
  CHECK(knots.span(0) == 2);
  CHECK(knots.span(0.999) == 2);
  CHECK(knots.span(1) == 4);
  CHECK(knots.span(1.5) == 4);
  CHECK(knots.span(2) == 5);
  CHECK(knots.span(4) == 5);

  const KnotVector closed = uniform(1, 3, Topology::closed, 0, 3);
  CHECK(closed.span(0) == 1);
  CHECK(closed.span(1) == 2);
  CHECK(closed.span(2.5) == 3);
}

TEST_CASE("the closed span reaches every interval, first to last") {
  const KnotVector knots = uniform(1, 3, Topology::closed, 0, 3);
  std::vector<int> found;
  found.reserve(3);
  for (int k = 0; k < knots.interval_count(); ++k) found.push_back(knots.span(k + 0.5));
  CHECK(found == std::vector<int>{1, 2, 3});
}

TEST_CASE("a hint changes the cost and never the answer") {
  const KnotVector knots = KnotVector::make(1, Topology::open, {0, 0, 0.1, 0.5, 0.6, 2, 2}).value();
  for (int k = 0; k <= 200; ++k) {
    const double t = k / 100.0;
    for (int hint = -3; hint <= 10; ++hint) REQUIRE(knots.span(t, hint) == knots.span(t));
  }
}

TEST_CASE("w is the translation and scaling of an interval, 0 on an empty one (THEORY 2.1)") {
  const KnotVector knots = KnotVector::make(2, Topology::open, {0, 0, 0, 1, 3, 4, 4, 4}).value();
  CHECK(translation_and_scaling(knots, 1, 3, 1.5) == 0.25);
  CHECK(translation_and_scaling(knots, 2, 2, 1.5) == 0.5);
  CHECK(translation_and_scaling(knots, 1, 0, 0.0) == 0);
  CHECK(translation_and_scaling(knots, 2, 5, 4.0) == 0);
}

}  // namespace knotwork::knot_vector_test
