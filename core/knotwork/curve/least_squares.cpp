#include "knotwork/curve/least_squares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>

#include "knotwork/basis/bspline_basis.h"
#include "knotwork/curve/banded_triangle.h"
#include "knotwork/curve/row_block.h"
#include "knotwork/curve/schoenberg_whitney.h"

namespace knotwork {
namespace {

using DataPoints = std::span<const Eigen::Vector3d>;

/// So many data go into the triangle at once: enough to make what is done once for all of them cheap, few enough to
/// stay in the first-level cache.
constexpr std::size_t most_rows_at_once = 128;

std::string element_path(const char* list, std::size_t i) { return std::string(list) + "[" + std::to_string(i) + "]"; }

/// The comparison that is quiet about a NaN, and false.
bool small_enough(double x) { return std::islessequal(std::abs(x), LeastSquaresOptions::largest_number); }

/// The first of the numbers that is not; without a branch for each as long as all are.
std::optional<std::size_t> first_not_small(std::span<const double> numbers) {
  constexpr std::size_t at_once = 64;
  for (std::size_t first = 0; first < numbers.size(); first += at_once) {
    const std::span<const double> here = numbers.subspan(first, std::min(at_once, numbers.size() - first));
    int good = 1;
    for (const double x : here) good &= static_cast<int>(small_enough(x));
    if (good != 0) continue;
    return first + static_cast<std::size_t>(std::find_if_not(here.begin(), here.end(), small_enough) - here.begin());
  }
  return std::nullopt;
}

Status check_fit_input(const KnotVector& knots, DataPoints points, std::span<const double> parameters,
                       const LeastSquaresOptions& options) {
  if (points.size() != parameters.size()) {
    return Error{"points", "There are " + std::to_string(points.size()) + " points for " +
                               std::to_string(parameters.size()) + " parameters."};
  }
  if (points.empty()) return Error{"points", "There are no points."};
  if (const std::optional<std::size_t> bad = first_not_small({points.front().data(), 3 * points.size()}))
    return Error{element_path("points", *bad / 3), "A point must have finite coordinates of reasonable size."};
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    if (!std::isfinite(parameters[j]))
      return Error{element_path("parameters", j), "A parameter must be a finite number."};
    if (!knots.closed() && (parameters[j] < knots.start() || parameters[j] > knots.end()))
      return Error{element_path("parameters", j), "A parameter must lie in the domain of the knots."};
  }
  if (!options.weights.empty() && options.weights.size() != points.size()) {
    return Error{"weights", "There are " + std::to_string(options.weights.size()) + " weights for " +
                                std::to_string(points.size()) + " points."};
  }
  for (std::size_t j = 0; j < options.weights.size(); ++j) {
    if (!small_enough(options.weights[j]) || options.weights[j] < 0)
      return Error{element_path("weights", j), "A weight must be a number of reasonable size, 0 or greater."};
  }
  if (!small_enough(options.smoothing) || options.smoothing < 0)
    return Error{"smoothing", "The smoothing must be a number of reasonable size, 0 or greater."};
  if (options.interpolate_ends) {
    if (knots.closed()) return Error{"interpolate_ends", "A closed curve has no ends."};
    if (knots[1] != knots.start() || knots[knots.count() + knots.degree() - 1] != knots.end())
      return Error{"interpolate_ends", "Only knots that are repeated at both ends hold the curve there."};
  }
  return success();
}

/// The data, span by span.
class DataBySpan {
 public:
  DataBySpan(const KnotVector& knots, DataPoints points, std::span<const double> parameters,
             std::span<const double> weights)
      : knots_(knots), points_(points), parameters_(parameters), weights_(weights) {
    const std::size_t spans = static_cast<std::size_t>(knots.interval_count());
    begin_.resize(spans + 1);
    count_.on.resize(spans + (knots.closed() ? 0 : 1));
    count_.inside.resize(spans);
    std::vector<double> different(spans * (static_cast<std::size_t>(knots.degree()) + 1));
    // Runs of data of one span: most data are sorted.
    struct Run {
      std::size_t begin, end, s;
    };
    std::vector<Run> runs;
    bool sorted = true;
    for (std::size_t j = 0; j < parameters.size();) {
      const int span = knots.span(parameter(j));
      const double from = knots[span], to = knots[span + 1];
      Run run{j, j + 1, static_cast<std::size_t>(span - knots.degree())};
      while (run.end < parameters.size() && from <= parameter(run.end) && parameter(run.end) < to) ++run.end;
      count_run(span, run.begin, run.end, different);
      sorted = sorted && (runs.empty() || runs.back().s <= run.s);
      begin_[run.s + 1] += run.end - run.begin;
      runs.push_back(run);
      j = run.end;
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    if (sorted) return;
    order_.resize(parameters.size());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (const Run& run : runs) {
      for (std::size_t j = run.begin; j < run.end; ++j) order_[next[run.s]++] = static_cast<std::uint32_t>(j);
    }
  }

  const KnotVector& knots() const { return knots_; }
  /// Of the data of weight above 0.
  const ParameterCount& count() const { return count_; }
  std::size_t total() const { return total_; }
  /// The places of the data of span p + s are begin(s) .. begin(s + 1) - 1.
  std::size_t begin(std::size_t s) const { return begin_[s]; }
  /// The datum at a place.
  std::size_t operator[](std::size_t place) const { return order_.empty() ? place : order_[place]; }

  double parameter(std::size_t j) const { return knots_.closed() ? knots_.reduced(parameters_[j]) : parameters_[j]; }
  double weight(std::size_t j) const { return weights_.empty() ? 1.0 : weights_[j]; }
  bool weighted() const { return !weights_.empty(); }
  const Eigen::Vector3d& point(std::size_t j) const { return points_[j]; }

 private:
  void count_run(int span, std::size_t begin, std::size_t end, std::vector<double>& different) {
    const std::size_t s = static_cast<std::size_t>(span - knots_.degree());
    std::size_t j = begin;
    // Once it is known that more parameters than the degree lie inside, only one at the knot itself could tell more.
    for (; j < end && (weighted() || count_.inside[s] <= knots_.degree()); ++j) {
      if (!(weight(j) > 0)) continue;
      ++total_;
      count_parameter(span, parameter(j), different);
    }
    total_ += end - j;
    bool on = false;
    for (; j < end; ++j) on |= parameter(j) == knots_[span];
    if (on) count_.on[s] = 1;
  }

  /// `different` holds p+1 places for every span, for the parameters counted inside it.
  void count_parameter(int span, double t, std::vector<double>& different) {
    const std::size_t s = static_cast<std::size_t>(span - knots_.degree());
    if (t == knots_[span]) {
      count_.on[s] = 1;
    } else if (t == knots_[span + 1]) {
      count_.on.back() = 1;
    } else if (count_.inside[s] <= knots_.degree()) {
      double* const known = &different[s * (static_cast<std::size_t>(knots_.degree()) + 1)];
      double* const end = known + count_.inside[s];
      if (std::find(known, end, t) != end) return;
      *end = t;
      ++count_.inside[s];
    }
  }

  const KnotVector& knots_;
  DataPoints points_;
  std::span<const double> parameters_, weights_;
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> order_;  ///< empty when the data come in the order of their spans
  ParameterCount count_;
  std::size_t total_ = 0;
};

/// visit(s, first, size) for the data span by span, no more than most_rows_at_once at a time.
template <class Visit>
void for_each_chunk(const DataBySpan& data, std::size_t s, Visit visit) {
  for (std::size_t first = data.begin(s); first < data.begin(s + 1); first += most_rows_at_once)
    visit(first, std::min(most_rows_at_once, data.begin(s + 1) - first));
}

/// The rows of A and of the data at the places first .. first + size - 1, all of span p + s, without their weights.
/// Columns between the basis functions and the data, if there are any, are zero.
void fill_rows(const DataBySpan& data, std::size_t s, std::size_t first, std::size_t size, RowBlock& rows) {
  const std::size_t functions = static_cast<std::size_t>(data.knots().degree()) + 1;
  rows.resize(size);
  std::array<double, most_rows_at_once> t;
  const std::span<double> x = rows.column(rows.columns() - 3), y = rows.column(rows.columns() - 2),
                          z = rows.column(rows.columns() - 1);
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t j = data[first + i];
    const Eigen::Vector3d& point = data.point(j);
    t[i] = data.parameter(j);
    x[i] = point.x();
    y[i] = point.y();
    z[i] = point.z();
  }
  // The rows of zeros that fill the block up take any parameter, and lose their values again.
  std::fill_n(t.begin() + size, rows.rows() - size, t[0]);
  bspline_basis_columns(data.knots(), static_cast<int>(s) + data.knots().degree(), std::span(t).first(rows.rows()),
                        rows.columns(0, functions));
  for (std::size_t k = 0; k < functions; ++k) std::fill_n(rows.column(k).data() + size, rows.rows() - size, 0.0);
  for (std::size_t k = functions; k + 3 < rows.columns(); ++k) std::fill_n(rows.column(k).data(), rows.rows(), 0.0);
}

void weigh_rows(const DataBySpan& data, std::size_t first, std::size_t size, RowBlock& rows) {
  std::array<double, most_rows_at_once> root;
  for (std::size_t i = 0; i < size; ++i) root[i] = std::sqrt(data.weight(data[first + i]));
  for (std::size_t k = 0; k < rows.columns(); ++k) {
    const std::span<double> column = rows.column(k);
    for (std::size_t i = 0; i < size; ++i) column[i] *= root[i];
  }
}

/// One row of the penalty, d_i for i = first + 1.
void fill_penalty(const KnotVector& knots, std::size_t first, double smoothing, RowBlock& rows) {
  const int i = static_cast<int>(first) + 1, p = knots.degree();
  // p times the distances from Greville abscissa i to its neighbours'. Neither is 0: no p+1 of these knots are equal.
  const double before = knots[i + p] - knots[i], behind = knots[i + 1 + p] - knots[i + 1];
  const double share = before / (before + behind), root = std::sqrt(smoothing);
  rows.clear(1);
  rows.column(0)[0] = 2 * root * (1 - share);
  rows.column(1)[0] = -2 * root;
  rows.column(2)[0] = 2 * root * share;
}

/// Takes column `k` of the rows, which belongs to a known control point, over to the right-hand sides.
void take_over(RowBlock& rows, std::size_t k, const Eigen::Vector3d& value) {
  const std::span<double> column = rows.column(k);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::span<double> side = rows.column(rows.columns() - 3 + c);
    for (std::size_t i = 0; i < column.size(); ++i) side[i] -= column[i] * value[static_cast<Eigen::Index>(c)];
  }
  std::fill(column.begin(), column.end(), 0.0);
}

/// The control points; or the one that is not determined.
Result<std::vector<Eigen::Vector3d>> solve_control_points(const DataBySpan& data, DataPoints points,
                                                          const LeastSquaresOptions& options) {
  const KnotVector& knots = data.knots();
  const std::size_t n = static_cast<std::size_t>(knots.count()), p = static_cast<std::size_t>(knots.degree());
  const bool smooth = options.smoothing > 0;
  const std::size_t width = smooth ? std::max<std::size_t>(p + 1, 3) : p + 1;
  const std::size_t penalties = !smooth ? 0 : knots.closed() ? n : n - 2;
  const std::size_t spans = static_cast<std::size_t>(knots.interval_count());

  BandedTriangle triangle(n, width, knots.topology());
  RowBlock rows(width + BandedTriangle::right_hand_sides, most_rows_at_once);
  const auto add = [&](std::size_t first) {
    if (options.interpolate_ends) {
      if (first == 0) take_over(rows, 0, points.front());
      if (first + width >= n) take_over(rows, n - 1 - first, points.back());
    }
    triangle.add(first, rows);
  };
  for (std::size_t first = 0; first < std::max(spans, penalties); ++first) {
    if (first < penalties) {
      fill_penalty(knots, first, options.smoothing, rows);
      add(first);
    }
    if (first >= spans) continue;
    for_each_chunk(data, first, [&](std::size_t place, std::size_t size) {
      fill_rows(data, first, place, size, rows);
      if (data.weighted()) weigh_rows(data, place, size, rows);
      add(first);
    });
  }
  if (options.interpolate_ends) {
    triangle.fix(0, points.front());
    triangle.fix(n - 1, points.back());
  }
  std::vector<Eigen::Vector3d> control_points(n);
  if (const std::optional<std::size_t> undetermined = triangle.solve(control_points)) {
    return Error{"parameters",
                 "The data determine control point " + std::to_string(*undetermined) +
                     " hardly or not at all: give more data near it, use other parameters or knots, or smooth more."};
  }
  return control_points;
}

/// The distances of the points in `rows`, filled, from the curve, on whose span p + s they lie.
void distances_from(const BSplineCurve& curve, std::size_t s, RowBlock& rows, std::span<double> out) {
  const std::size_t functions = static_cast<std::size_t>(curve.degree()) + 1;
  std::array<Eigen::Vector3d, KnotVector::max_degree + 1> local;
  for (std::size_t k = 0; k < functions; ++k) local[k] = curve.point(static_cast<int>(s + k));
  for (std::size_t i = 0; i < rows.rows(); i += RowBlock::lanes) {
    RowBlock::Lanes squares = RowBlock::Lanes::Zero();
    for (std::size_t c = 0; c < 3; ++c) {
      RowBlock::Lanes error = RowBlock::at(rows.column(functions + c).data() + i);
      for (std::size_t k = 0; k < functions; ++k)
        error -= RowBlock::at(rows.column(k).data() + i) * local[k][static_cast<Eigen::Index>(c)];
      squares += error * error;
    }
    RowBlock::at(out.data() + i) = squares.sqrt();
  }
}

LeastSquaresFit measure_fit(const DataBySpan& data, BSplineCurve curve, std::size_t size) {
  const KnotVector& knots = data.knots();
  LeastSquaresFit fit{std::move(curve), 0, 0, std::vector<double>(size)};
  RowBlock rows(static_cast<std::size_t>(knots.degree()) + 4, most_rows_at_once);
  std::array<double, most_rows_at_once> distance;
  double squares = 0, weights = 0;
  for (std::size_t s = 0; s < static_cast<std::size_t>(knots.interval_count()); ++s) {
    for_each_chunk(data, s, [&](std::size_t first, std::size_t here) {
      fill_rows(data, s, first, here, rows);
      distances_from(fit.curve, s, rows, distance);
      double maximum = fit.maximum, square = 0, weight = 0;
      for (std::size_t i = 0; i < here; ++i) {
        const std::size_t j = data[first + i];
        fit.residuals[j] = distance[i];
        maximum = std::max(maximum, distance[i]);
        square += data.weight(j) * distance[i] * distance[i];
        weight += data.weight(j);
      }
      fit.maximum = maximum;
      squares += square;
      weights += weight;
    });
  }
  if (weights > 0) fit.rms = std::sqrt(squares / weights);
  return fit;
}

}  // namespace

Result<LeastSquaresFit> fit_least_squares(const KnotVector& knots, DataPoints points,
                                          std::span<const double> parameters, const LeastSquaresOptions& options) {
  if (Status status = check_fit_input(knots, points, parameters, options); !status) return status.error();
  const DataBySpan data(knots, points, parameters, options.weights);
  const int first = options.interpolate_ends ? 1 : 0, last = knots.count() - 1 - first;
  if (options.smoothing == 0) {
    const std::size_t wanted = static_cast<std::size_t>(last - first + 1);
    if (data.total() < wanted) {
      return Error{"points", "There are " + std::to_string(data.total()) + " points for " + std::to_string(wanted) +
                                 " control points: give more points, use fewer control points, or smooth."};
    }
    if (Status status = check_schoenberg_whitney(knots, data.count(), first, last); !status) return status.error();
  }
  Result<std::vector<Eigen::Vector3d>> control_points = solve_control_points(data, points, options);
  if (!control_points) return control_points.error();
  Result<BSplineCurve> curve = BSplineCurve::make(knots, std::move(control_points).value());
  if (!curve) return curve.error();
  return measure_fit(data, std::move(curve).value(), points.size());
}

}  // namespace knotwork
