#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "benchmark/reference.h"
#include "benchmark/works.h"
#include "knotwork/curve/lane_riesenfeld.h"
#include "knotwork/curve/least_squares.h"
#include "knotwork/curve/spline_pieces.h"
#include "knotwork/surface/surface_measures.h"

namespace knotwork::benchmark {
namespace {

/// The bound for all positions, rivals' and ours.
constexpr double position_tolerance = 1e-12;

constexpr CurveWork all_curve_works[] = {
    {"W1 curve, position, 7 points", 7, 0, true},
    {"W1 curve, position, 1000 points", 1000, 0, true},
    {"W1 curve, two derivatives, 7 points", 7, 2, true},
    {"W1 curve, two derivatives, 1000 points", 1000, 2, true},
    {"W1 curve, position, 7 points, shuffled", 7, 0, false},
    {"W1 curve, position, 1000 points, shuffled", 1000, 0, false},
};

/// The error of what is in the sequence against its largest member; NaN counts as infinite.
class RelativeError {
 public:
  void add(const Eigen::Vector3d& actual, const PrecisePoint& expected) {
    const double apart = static_cast<double>((actual.cast<Precise>() - expected).norm());
    if (!(apart <= error_)) error_ = std::isnan(apart) ? HUGE_VAL : apart;
    size_ = std::max(size_, static_cast<double>(expected.norm()));
  }
  double value() const { return size_ > 0 ? error_ / size_ : HUGE_VAL; }

 private:
  double error_ = 0, size_ = 0;
};

/// Every place is checked, but every so many where software computes long double, as in WebAssembly and on ARM: coprime
/// to all lengths and sides.
constexpr std::size_t step = std::numeric_limits<Precise>::digits > 64 ? 97 : 1;
/// Other places for each contender.
std::size_t first_checked(const std::string& name) { return std::hash<std::string>()(name) % step; }

Frame frame_of(const SurfaceFrame& at) {
  Frame frame;
  frame << at.s, at.su, at.sv, at.normal;
  return frame;
}

/// reference(u)(v): the frame at (u, v).
template <class Reference>
Kernel grid_contender(const GridWork& work, const std::string& contender, std::function<void()> run,
                      const std::function<Frame(std::size_t)>& at, bool normals, const Reference& reference) {
  const std::string name = work.name + " | " + contender;
  const auto error = [=] {
    const Eigen::Index columns = !work.frames ? 1 : normals ? 4 : 3;
    std::array<RelativeError, 4> errors;
    std::size_t place = first_checked(name);
    for (std::size_t a = 0; a < work.side; ++a) {
      const auto row = reference(work.u[a]);
      for (; place < (a + 1) * work.side; place += step) {
        const Frame actual = at(place);
        const PreciseFrame expected = row(work.v[place - a * work.side]);
        for (Eigen::Index c = 0; c < columns; ++c)
          errors[static_cast<std::size_t>(c)].add(actual.col(c), expected.col(c));
      }
    }
    double worst = 0;
    for (Eigen::Index c = 0; c < columns; ++c) worst = std::max(worst, errors[static_cast<std::size_t>(c)].value());
    return worst;
  };
  return {name, work.side * work.side, std::move(run), error, position_tolerance};
}

/// The blending torus in the four-patch form, in long double.
PreciseFrame precise_blend(const BlendingSurface& surface, double u, double v) {
  const KnotVector &knots_u = surface.knots_u(), &knots_v = surface.knots_v();
  struct Direction {
    int span;
    std::array<Precise, 2> weight, slope;
  };
  // B = 6 w^5 - 15 w^4 + 10 w^3.
  const auto direction = [](const KnotVector& knots, double t) {
    const int span = knots.span(t);
    const Precise width = static_cast<Precise>(knots[span + 1]) - knots[span], w = (t - knots[span]) / width;
    const Precise b = w * w * w * ((6 * w - 15) * w + 10), slope = 30 * w * w * (1 - w) * (1 - w) / width;
    return Direction{span, {1 - b, b}, {-slope, slope}};
  };
  const Direction along_u = direction(knots_u, u), along_v = direction(knots_v, v);
  const Sheet sheet;  // rolled up
  const Precise wheel = sheet.closed_radius_u, tube = sheet.closed_radius_v, a = u, b = v;
  const Precise across = wheel + tube * std::cos(b);
  const PrecisePoint m(across * std::cos(a), across * std::sin(a), tube * std::sin(b));
  const PrecisePoint m_u(-across * std::sin(a), across * std::cos(a), 0);
  const PrecisePoint m_v(-tube * std::sin(b) * std::cos(a), -tube * std::sin(b) * std::sin(a), tube * std::cos(b));
  PrecisePoint s = PrecisePoint::Zero(), su = s, sv = s;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const auto [own_i, own_j] = surface.wrapped(along_u.span - 1 + i, along_v.span - 1 + j);
      const Eigen::Matrix<Precise, 3, 4> map = surface.model_map(own_i, own_j).matrix().topRows<3>().cast<Precise>();
      const PrecisePoint local = map.leftCols<3>() * m + map.col(3);
      const PrecisePoint local_u = map.leftCols<3>() * m_u, local_v = map.leftCols<3>() * m_v;
      const std::size_t p = static_cast<std::size_t>(i), q = static_cast<std::size_t>(j);
      s += along_u.weight[p] * along_v.weight[q] * local;
      su += along_v.weight[q] * (along_u.slope[p] * local + along_u.weight[p] * local_u);
      sv += along_u.weight[p] * (along_v.slope[q] * local + along_v.weight[q] * local_v);
    }
  }
  return with_normal(s, su, sv);
}

void add_curves(std::vector<Kernel>& rows) {
  for (const CurveWork& work : curve_works()) {
    const auto pieces = std::make_shared<const SplinePieces>(work.curve());
    rows.push_back(curve_contender(work, "Knotwork", [=](std::span<const double> t, Eigen::Vector3d* out) {
      pieces->evaluate(t, work.order, {out, t.size() * (static_cast<std::size_t>(work.order) + 1)});
    }));
    const auto curve = std::make_shared<const BSplineCurve>(work.curve());
    rows.push_back(curve_contender(work, "Knotwork, plain", [=](std::span<const double> t, Eigen::Vector3d* out) {
      curve->evaluate(t, work.order, {out, t.size() * (static_cast<std::size_t>(work.order) + 1)});
    }));
  }
}

void add_surfaces(std::vector<Kernel>& rows) {
  const auto surface = std::make_shared<const BSplineSurface>(surface_work());
  const GridWork points = surface_grid(false), frames = surface_grid(true);
  const auto s = std::make_shared<std::vector<Eigen::Vector3d>>(points.side * points.side);
  rows.push_back(surface_contender(
      points, "Knotwork", [=] { surface->evaluate_grid(points.u, points.v, std::span(*s)); },
      [=](std::size_t k) {
        Frame frame = Frame::Zero();
        frame.col(0) = (*s)[k];
        return frame;
      }));
  const auto all = std::make_shared<std::vector<SurfaceFrame>>(frames.side * frames.side);
  rows.push_back(surface_contender(
      frames, "Knotwork", [=] { surface->evaluate_grid(frames.u, frames.v, std::span(*all)); },
      [=](std::size_t k) { return frame_of((*all)[k]); }));
  const auto jets = std::make_shared<std::vector<SurfaceJet>>(frames.side * frames.side);
  rows.push_back(surface_contender(
      frames, "Knotwork, plain", [=] { surface->evaluate_grid(frames.u, frames.v, std::span(*jets)); },
      [=](std::size_t k) {
        const SurfaceJet& jet = (*jets)[k];
        return frame_of({jet.s, jet.su, jet.sv, unit_normal(jet)});
      }));
}

/// 10^5 data on a spline of 1000 control points: the fit must bring it back.
void add_fit(std::vector<Kernel>& rows) {
  constexpr std::size_t data_count = 100000;
  const KnotVector knots = KnotVector::uniform(3, 1000, Topology::open, 0, 1).value();
  const BSplineCurve truth = BSplineCurve::make(knots, wavy_points(1000)).value();
  const std::vector<double> x = parameters(0, 1, data_count);
  std::vector<Eigen::Vector3d> data;
  data.reserve(data_count);
  for (const double t : x) data.push_back(precise_curve<1>(truth, t)[0].cast<double>());
  const auto fit = std::make_shared<std::optional<Result<LeastSquaresFit>>>();
  const auto error = [=] {
    return fit->has_value() && **fit ? difference((*fit)->value().curve.points(), truth.points()) : HUGE_VAL;
  };
  // For the whole: a thousandth of a second is what the target is in.
  rows.push_back(
      {"W3 least squares | Knotwork", 1, [=] { *fit = fit_least_squares(knots, data, x); }, error, position_tolerance});
}

void add_blending(std::vector<Kernel>& rows, int patches) {
  const auto surface = std::make_shared<const BlendingSurface>(blending_work(patches));
  const GridWork grid = blending_grid(patches);
  const auto frames = std::make_shared<std::vector<SurfaceFrame>>(grid.side * grid.side);
  const auto at = [=](std::size_t k) { return frame_of((*frames)[k]); };
  rows.push_back(blending_contender(
      grid, patches, "Knotwork", [=] { surface->evaluate_grid(grid.u, grid.v, std::span(*frames)); }, at));
  const auto four_patches = [=] {
    for (std::size_t a = 0; a < grid.side; ++a) {
      for (std::size_t b = 0; b < grid.side; ++b) {
        const SurfaceJet jet = surface->evaluate_four_patches(grid.u[a], grid.v[b]);
        (*frames)[a * grid.side + b] = {jet.s, jet.su, jet.sv, unit_normal(jet)};
      }
    }
  };
  rows.push_back(blending_contender(grid, patches, "four patches", four_patches, at));
}

/// W5: 16 levels of 7 points, beside the passes that they are held to.
void add_subdivision(std::vector<Kernel>& rows) {
  constexpr int levels = 16;
  const LaneRiesenfeld scheme;
  const std::vector<Eigen::Vector3d> polygon = wavy_points(7);
  const std::size_t count = subdivided_count(scheme, polygon.size(), levels);
  const auto by_passes = [=] { return subdivided_by_passes(scheme, polygon, levels); };
  const auto out = std::make_shared<std::vector<Eigen::Vector3d>>(count);
  const auto error = [=] { return difference(*out, by_passes()); };
  constexpr double bit_for_bit = 0;
  rows.push_back(
      {"W5 subdivision | Knotwork", count, [=] { subdivide(scheme, polygon, levels, *out); }, error, bit_for_bit});
  rows.push_back({"W5 subdivision | passes", count, [=] { *out = by_passes(); }, error, bit_for_bit});
}

}  // namespace

BSplineCurve CurveWork::curve() const {
  return BSplineCurve::make(KnotVector::uniform(3, points, Topology::open, 0, 1).value(),
                            wavy_points(static_cast<std::size_t>(points)))
      .value();
}

std::span<const CurveWork> curve_works() { return all_curve_works; }

Kernel curve_contender(const CurveWork& work, const std::string& contender, const EvaluateCurve& evaluate) {
  const std::vector<double> sorted = parameters(0, 1, curve_parameters);
  const auto t = std::make_shared<const std::vector<double>>(work.sorted ? sorted : shuffled(sorted));
  const std::size_t values = static_cast<std::size_t>(work.order) + 1;
  const auto out = std::make_shared<std::vector<Eigen::Vector3d>>(parameters_of_a_call * values);
  const auto call = [=](std::size_t first) {
    const std::span<const double> here =
        std::span(*t).subspan(first, std::min(parameters_of_a_call, t->size() - first));
    evaluate(here, out->data());
    return here;
  };
  const auto run = [=] {
    for (std::size_t first = 0; first < t->size(); first += parameters_of_a_call) call(first);
  };
  const std::string name = std::string(work.name) + " | " + contender;
  const auto error = [=] {
    const BSplineCurve curve = work.curve();
    std::array<RelativeError, 3> errors;
    std::size_t place = first_checked(name);
    for (std::size_t first = 0; first < t->size(); first += parameters_of_a_call) {
      const std::size_t end = first + call(first).size();
      for (; place < end; place += step) {
        const Eigen::Vector3d* const actual = &(*out)[(place - first) * values];
        if (work.order == 0) {
          errors[0].add(*actual, precise_curve<1>(curve, (*t)[place])[0]);
        } else {
          const auto expected = precise_curve<3>(curve, (*t)[place]);
          for (std::size_t k = 0; k < values; ++k) errors[k].add(actual[k], expected[k]);
        }
      }
    }
    double worst = 0;
    for (std::size_t k = 0; k < values; ++k) worst = std::max(worst, errors[k].value());
    return worst;
  };
  return {name, curve_parameters, run, error, position_tolerance};
}

BSplineSurface surface_work() {
  const KnotVector knots = KnotVector::uniform(3, 32, Topology::open, 0, 1).value();
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 32; ++i) {
    for (int j = 0; j < 32; ++j) points.emplace_back(i / 31.0, j / 31.0, 0.2 * std::sin(0.7 * i) * std::cos(0.9 * j));
  }
  return BSplineSurface::make(knots, knots, points).value();
}

GridWork surface_grid(bool frames) {
  constexpr std::size_t side = 1000;
  return {frames ? "W2 surface, partials and normal" : "W2 surface, position", side, frames, parameters(0, 1, side),
          parameters(0, 1, side)};
}

BlendingSurface blending_work(int patches) {
  const ModelSurface model = Sheet{};  // rolled up, a torus
  const SurfaceDomain over = domain(model);
  const KnotVector u = KnotVector::uniform(1, patches, Topology::closed, over.u.start, over.u.end).value();
  const KnotVector v = KnotVector::uniform(1, patches, Topology::closed, over.v.start, over.v.end).value();
  BlendingSurface surface =
      BlendingSurface::make(model, u, v, BlendingFunction::make(BlendingKind::polynomial2).value(),
                            BlendingSurface::unmoved_locals(model, u, v))
          .value();
  for (int i = 0; i < patches; ++i) {
    for (int j = 0; j < patches; ++j) {
      const double angle = 0.2 * std::sin(1.0 + 2.0 * i + 3.0 * j);
      surface.set_local(i, j,
                        Eigen::Translation3d(0.1 * std::cos(i), 0.1 * std::sin(j), 0.05) * surface.local(i, j) *
                            Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
    }
  }
  return surface;
}

GridWork blending_grid(int patches) {
  constexpr std::size_t side = 500;
  const std::vector<double> t = parameters(-std::numbers::pi, std::numbers::pi, side);
  const std::string n = std::to_string(patches);
  return {"W4 blending torus, " + n + " x " + n, side, true, t, t};
}

Kernel surface_contender(const GridWork& work, const std::string& contender, std::function<void()> run,
                         const std::function<Frame(std::size_t)>& at, bool normals) {
  return grid_contender(work, contender, std::move(run), at, normals,
                        [surface = surface_work()](double u) { return PreciseRow(surface, u); });
}

Kernel blending_contender(const GridWork& work, int patches, const std::string& contender, std::function<void()> run,
                          const std::function<Frame(std::size_t)>& at) {
  return grid_contender(work, contender, std::move(run), at, true, [surface = blending_work(patches)](double u) {
    return [&surface, u](double v) { return precise_blend(surface, u, v); };
  });
}

std::vector<Kernel> work_kernels() {
  std::vector<Kernel> rows;
  add_curves(rows);
  add_surfaces(rows);
  add_fit(rows);
  for (const int patches : {3, 20}) add_blending(rows, patches);
  add_subdivision(rows);
  return rows;
}

}  // namespace knotwork::benchmark
