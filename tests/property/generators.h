#pragma once

// What RapidCheck draws for the laws: knot vectors, points, parameters. Every draw is made of whole numbers, so that a
// failure shrinks to a short one, and all knots are whole multiples of one power of two, so that they and their copies
// one period later are exact: what a law then shows is the error of the evaluation, not that of the knots.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <rapidcheck.h>
#include <Eigen/Geometry>

#include "knotwork/basis/knot_vector.h"
#include "unit/bspline_cases.h"

namespace knotwork {

/// How RapidCheck prints a knot vector of a counterexample.
inline std::ostream& operator<<(std::ostream& out, const KnotVector& knots) {
  out << (knots.closed() ? "closed" : "open") << ", degree " << knots.degree() << ", n " << knots.count() << ":";
  const std::streamsize digits = out.precision(17);
  for (const double t : knots.knots()) out << ' ' << t;
  out.precision(digits);
  return out;
}

}  // namespace knotwork

namespace knotwork::test {

/// Fails the running law unless the condition holds; says where. (RC_ASSERT would print both sides, at the price of
/// templates for every pair of types.)
inline void holds(bool condition, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  if (!condition) RC_FAIL(std::string(file) + ":" + std::to_string(line));
}

/// Fails the running law unless the comparison holds.
inline void expect(const Closeness& closeness, const char* what) {
  if (!closeness.within)
    RC_FAIL(std::string(what) + ": error " + std::to_string(closeness.error / closeness.bound) + " of the bound");
}

struct KnotWish {
  int least_degree = 1, most_degree = 9;
  /// How much lower than the degree inner multiplicities stay.
  int spared = 0;
  std::vector<Ends> ends = {Ends::clamped, Ends::unclamped, Ends::closed};
  /// Intervals have widths of 1 to 15 times 2^0 .. 2^most_exponent units.
  int most_exponent = 30;
  int most_intervals = 8;
};

/// A width in units.
inline double drawn_width(const KnotWish& wish) {
  return std::ldexp(*rc::gen::inRange(1, 16), *rc::gen::inRange(0, wish.most_exponent + 1));
}

/// Valid knot vectors with repeated knots, open and closed, whose intervals are 1e-9 to 1e10 wide, both in one vector.
inline rc::Gen<KnotVector> knot_vectors(KnotWish wish = {}) {
  return rc::gen::exec([wish] {
    const int degree = *rc::gen::inRange(wish.least_degree, wish.most_degree + 1);
    const Ends ends = *rc::gen::elementOf(wish.ends);
    const int intervals = *rc::gen::inRange(1, wish.most_intervals + 1);
    const bool closed = ends == Ends::closed;
    // Distinct knots of the domain [0, ..], in units, with their multiplicities; closed, the seam's first.
    std::vector<double> inside;
    double end = 0;
    const auto repeat = [&] {
      const int most = std::max(1, degree - wish.spared);
      inside.insert(inside.end(), static_cast<std::size_t>(*rc::gen::inRange(1, most + 1)), end);
    };
    for (int k = 0; k < intervals || (closed && static_cast<int>(inside.size()) < std::max(2, degree)); ++k) {
      if (closed || k > 0) repeat();
      end += drawn_width(wish);
    }
    std::vector<double> knots;
    if (closed) {
      const int n = static_cast<int>(inside.size());
      const int seam = static_cast<int>(std::count(inside.begin(), inside.end(), 0.0));
      // t_p may be any copy of the start but, so that the domain is one period, the count stays n.
      for (int k = seam - 1 - degree; k <= seam - 1 + n + degree; ++k) {
        const int round = k >= 0 ? k / n : -((n - 1 - k) / n);
        knots.push_back(inside[static_cast<std::size_t>(k - round * n)] + round * end);
      }
    } else {
      double before = 0, behind = end;
      knots = inside;
      for (int k = 0; k <= degree; ++k) {
        knots.insert(knots.begin(), before);
        knots.push_back(behind);
        if (ends == Ends::unclamped) before -= drawn_width(wish), behind += drawn_width(wish);
      }
    }
    const double unit = std::ldexp(1.0, *rc::gen::inRange(-30, 1));
    const double shift = *rc::gen::arbitrary<std::int16_t>();
    for (double& t : knots) t = (t + shift) * unit;
    return KnotVector::make(degree, closed ? Topology::closed : Topology::open, std::move(knots)).value();
  });
}

/// Points whose coordinates are 64ths, up to 512.
inline rc::Gen<std::vector<Eigen::Vector3d>> points(std::size_t count) {
  return rc::gen::map(rc::gen::container<std::vector<std::int16_t>>(3 * count, rc::gen::arbitrary<std::int16_t>()),
                      [](const std::vector<std::int16_t>& numbers) {
                        std::vector<Eigen::Vector3d> made;
                        for (std::size_t k = 0; k + 2 < numbers.size(); k += 3)
                          made.emplace_back(numbers[k] / 64.0, numbers[k + 1] / 64.0, numbers[k + 2] / 64.0);
                        return made;
                      });
}
inline Eigen::Vector3d drawn_point() { return (*points(1)).front(); }

inline BSplineCurve drawn_curve(const KnotWish& wish = {}) {
  KnotVector knots = *knot_vectors(wish);
  std::vector<Eigen::Vector3d> control = *points(static_cast<std::size_t>(knots.count()));
  return BSplineCurve::make(std::move(knots), std::move(control)).value();
}

/// An affine map with entries up to 512.
inline Eigen::Affine3d drawn_map() {
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  const std::vector<Eigen::Vector3d> columns = *points(4);
  for (int c = 0; c < 4; ++c) map.matrix().block<3, 1>(0, c) = columns[static_cast<std::size_t>(c)];
  return map;
}

/// The indices of the intervals of the domain that are not empty.
inline std::vector<int> spans(const KnotVector& knots) {
  std::vector<int> list;
  for (int i = knots.degree(); i <= knots.last_span(); ++i) {
    if (knots[i] < knots[i + 1]) list.push_back(i);
  }
  return list;
}

/// A parameter of the domain: in one of its intervals, at a 64th of it; knots and ends are among them.
inline double drawn_parameter(const KnotVector& knots) {
  const int i = *rc::gen::elementOf(spans(knots));
  return knots[i] + (knots[i + 1] - knots[i]) * (*rc::gen::inRange(0, 65) / 64.0);
}
/// The same, inside the interval.
inline double drawn_inner_parameter(const KnotVector& knots) {
  const int i = *rc::gen::elementOf(spans(knots));
  return knots[i] + (knots[i + 1] - knots[i]) * (*rc::gen::inRange(1, 64) / 64.0);
}

}  // namespace knotwork::test
