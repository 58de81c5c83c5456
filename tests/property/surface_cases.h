#pragma once

#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "knotwork/surface/blending_surface.h"
#include "unit/oracle.h"

namespace knotwork::test {

/// Reproducible numbers in [-1,1], the same on every platform (a multiplicative generator of period 2^62).
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(2 * seed + 1) {}
  double operator()() {
    state_ *= 6364136223846793005u;
    return static_cast<double>(state_ >> 11) * 0x1p-52 - 1;
  }
  Eigen::Vector3d vector() {
    const double x = (*this)(), y = (*this)(), z = (*this)();
    return {x, y, z};
  }
  /// Translation, rotation, scale and shear, all moderate.
  Eigen::Affine3d affine() {
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    for (int k = 0; k < 3; ++k) map.matrix().col(k).head<3>() += 0.3 * vector();
    map.translation() = 0.4 * vector();
    return map;
  }

 private:
  std::uint64_t state_;
};

struct SurfaceCase {
  std::string name;
  BlendingSurface surface;
};

/// Knots over a domain: n locals, equidistant or not.
inline KnotVector case_knots(int n, Topology topology, const Interval& range, bool uniform) {
  if (uniform) return KnotVector::uniform(1, n, topology, range.start, range.end).value();
  const bool closed = topology == Topology::closed;
  const int intervals = closed ? n : n - 1;
  const double length = range.end - range.start;
  // Widths 1, 2, 1, 2, ... and the last 1.5.
  std::vector<double> at{0};
  for (int k = 0; k < intervals; ++k) at.push_back(at.back() + (k == intervals - 1 ? 1.5 : 1 + k % 2));
  const double total = at.back();
  for (double& t : at) t = range.start + length * (t / total);
  at.back() = range.end;
  const double before = closed ? range.start - (at.back() - at[at.size() - 2]) : range.start;
  const double after = closed ? range.end + (at[1] - at[0]) : range.end;
  at.insert(at.begin(), before);
  at.push_back(after);
  return KnotVector::make(1, topology, std::move(at)).value();
}

/// Every local moved by its own affine map: with unmoved locals nothing would be detected (THEORY 2.7, P1).
inline BlendingSurface moved(BlendingSurface surface, std::uint64_t seed) {
  Numbers numbers(seed);
  for (int i = 0; i < surface.knots_u().count(); ++i) {
    for (int j = 0; j < surface.knots_v().count(); ++j) {
      surface.set_local(i, j, surface.local(i, j) * numbers.affine());
    }
  }
  return surface;
}

inline BlendingSurface unmoved(const ModelSurface& model, const KnotVector& u, const KnotVector& v,
                               const BlendingFunction& b) {
  return BlendingSurface::make(model, u, v, b, BlendingSurface::unmoved_locals(model, u, v)).value();
}

/// Every B-function once, at its default parameter, and a lopsided expo-rational one.
inline std::vector<BlendingFunction> case_functions() {
  std::vector<BlendingFunction> functions;
  for (const BlendingFamily& family : blending_families()) {
    functions.push_back(BlendingFunction::make(family.kind, family.parameter_default).value());
  }
  functions.push_back(BlendingFunction::make(ExpoRationalParameters{1, 1, 2, 0.4}).value());
  return functions;
}

/// All four topologies over every model that allows them, n from 2 up, uniform and not, every B-function, all moved.
inline std::vector<SurfaceCase> surface_cases() {
  struct Shape {
    const char* name;
    ModelSurface model;
  };
  const Shape shapes[] = {{"plane", plane_surface()},
                          {"cylinder", cylinder_surface(1, 1.3, 2)},
                          {"torus", torus_surface(1, 0.4, 0.6)},
                          {"sheet", Sheet{1, 1}},
                          {"half-rolled sheet", Sheet{0.6, 1}}};
  struct Size {
    int n_u, n_v;
    bool uniform;
  };
  const Size sizes[] = {{2, 2, true}, {2, 3, false}, {3, 4, false}, {5, 3, true}};
  const std::vector<BlendingFunction> functions = case_functions();

  std::vector<SurfaceCase> cases;
  std::size_t next_function = 0;
  for (const Shape& shape : shapes) {
    const SurfaceDomain where = domain(shape.model);
    for (const Topology u : {Topology::open, Topology::closed}) {
      for (const Topology v : {Topology::open, Topology::closed}) {
        if (u == Topology::closed && where.closure_u == Closure::open) continue;
        if (v == Topology::closed && where.closure_v == Closure::open) continue;
        for (const Size& size : sizes) {
          // Three functions a surface, taken in turn, so that each meets every topology.
          for (int k = 0; k < 3; ++k) {
            const BlendingFunction& b = functions[next_function++ % functions.size()];
            const std::string name = std::string(shape.name) + (u == Topology::open ? " open" : " closed") +
                                     (v == Topology::open ? "/open " : "/closed ") + std::to_string(size.n_u) + "x" +
                                     std::to_string(size.n_v) + (size.uniform ? " uniform " : " non-uniform ") +
                                     std::string(blending_family(b.kind()).id);
            cases.push_back({name, moved(unmoved(shape.model, case_knots(size.n_u, u, where.u, size.uniform),
                                                 case_knots(size.n_v, v, where.v, size.uniform), b),
                                         cases.size() + 1)});
          }
        }
      }
    }
  }
  return cases;
}

/// Bezier-Hermite locals, and models closed with a twist, with both kinds of locals; all moved.
inline std::vector<SurfaceCase> further_surface_cases() {
  constexpr LocalSurfaceKind whole = LocalSurfaceKind::sub_surface, taylor = LocalSurfaceKind::bezier_hermite;
  const Topology open = Topology::open, closed = Topology::closed;
  const auto model = [](const char* id) { return ModelSurface(make_catalogue_surface(id).value()); };
  const double pi = std::numbers::pi;
  const auto knots = [](Topology topology, std::vector<double> t) {
    return KnotVector::make(1, topology, std::move(t)).value();
  };
  const auto even = [](int n, Topology topology, double start, double end) {
    return KnotVector::uniform(1, n, topology, start, end).value();
  };
  // Symmetric about 0, and, modulo their period 2 pi, about 0 too.
  const KnotVector strip = knots(open, {-1, -1, -0.375, 0.375, 1, 1});
  const KnotVector ring = knots(closed, {-2.0, 0, 2.0, 2 * pi - 2.0, 2 * pi, 2 * pi + 2.0});
  const KnotVector turn = case_knots(4, closed, {0, 2 * pi}, false);
  struct Row {
    const char* name;
    ModelSurface model;
    KnotVector u, v;
    LocalSurfaces locals;
  };
  const Row rows[] = {
      {"torus 3,3", torus_surface(1, 0.4, 0.6), turn, even(3, closed, 0, 2 * pi), {taylor, 3, 3}},
      {"torus 1,2", torus_surface(1, 0.4, 0.6), even(4, closed, 0, 2 * pi), even(4, open, 0, 2 * pi), {taylor, 1, 2}},
      {"half-rolled sheet 2,3", Sheet{0.6, 1}, even(4, open, -pi, pi), even(3, closed, -pi, pi), {taylor, 2, 3}},
      {"bent plane 3,1", model("enneper"), even(3, open, -1.5, 1.5), even(4, open, -1.5, 1.5), {taylor, 3, 1}},
      {"moebius", model("moebius"), strip, even(3, closed, -0.5 * pi, 1.5 * pi), {whole}},
      {"moebius 2,3", model("moebius"), strip, even(3, closed, -0.5 * pi, 1.5 * pi), {taylor, 2, 3}},
      {"open moebius 2,2", model("moebius"), even(3, open, -1, 1), even(3, open, -0.5 * pi, 1.5 * pi), {taylor, 2, 2}},
      {"figure-eight klein", model("figure-eight-klein-bottle"), turn, ring, {whole}},
      {"figure-eight klein 3,2", model("figure-eight-klein-bottle"), turn, ring, {taylor, 3, 2}},
      {"steiner", model("steiner"), even(3, closed, 0, pi), even(4, closed, 0, pi), {whole}},
      {"boy 2,2", model("boy"), even(4, closed, 0, pi), even(3, closed, 0, pi), {taylor, 2, 2}},
  };
  std::vector<BlendingFunction> functions;
  for (const BlendingFunction& b : case_functions()) {
    if (b.symmetric()) functions.push_back(b);
  }
  std::vector<SurfaceCase> cases;
  std::size_t next_function = 0;
  for (const Row& row : rows) {
    for (int k = 0; k < 3; ++k) {
      const BlendingFunction& b = functions[next_function++ % functions.size()];
      BlendingSurface surface =
          BlendingSurface::make(row.model, row.u, row.v, b, BlendingSurface::unmoved_locals(row.model, row.u, row.v),
                                row.locals)
              .value();
      cases.push_back({std::string(row.name) + " " + std::string(blending_family(b.kind()).id),
                       moved(std::move(surface), cases.size() + 77)});
    }
  }
  return cases;
}

inline std::vector<SurfaceCase> all_surface_cases() {
  std::vector<SurfaceCase> cases = surface_cases();
  for (SurfaceCase& entry : further_surface_cases()) cases.push_back(std::move(entry));
  return cases;
}

/// Whether t lies strictly inside the support (t_i, t_{i+2}) of local i, periods counted.
inline bool in_support(const KnotVector& knots, int i, double t) {
  for (int k = -1; k <= 1; ++k) {
    const double shifted = t + (knots.closed() ? k * knots.period() : 0);
    if (knots[i] < shifted && shifted < knots[i + 2]) return true;
    // The clamped end of an open direction belongs to its local.
    if (!knots.closed() && t == knots[i + 1]) return true;
    if (!knots.closed()) break;
  }
  return false;
}

/// Parameters inside every knot interval at the given fractions.
inline std::vector<double> interval_parameters(const KnotVector& knots, const std::vector<double>& fractions) {
  std::vector<double> t;
  for (int i = knots.degree(); i <= knots.last_span(); ++i) {
    for (const double w : fractions) t.push_back(knots[i] + w * (knots[i + 1] - knots[i]));
  }
  return t;
}

/// The largest norm of each vector of the jet over a coarse grid: its natural magnitude on this surface.
struct JetScale {
  double part[6] = {};
};
inline JetScale jet_scale(const BlendingSurface& surface) {
  JetScale scale;
  for (const double u : interval_parameters(surface.knots_u(), {0, 0.3, 0.5, 0.8})) {
    for (const double v : interval_parameters(surface.knots_v(), {0, 0.3, 0.5, 0.8})) {
      const SurfaceJet jet = surface.evaluate(u, v);
      for (int k = 0; k < 6; ++k) scale.part[k] = std::max(scale.part[k], jet_part(jet, k).norm());
    }
  }
  return scale;
}

}  // namespace knotwork::test
