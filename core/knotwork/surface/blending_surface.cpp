#include "knotwork/surface/blending_surface.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "knotwork/basis/local_blend.h"
#include "knotwork/surface/mixed_partials.h"

namespace knotwork {
namespace {

using Matrix34 = Eigen::Matrix<double, 3, 4>;

/// A and its partials at one vertex times the model's jet.
SurfaceJet blended(const LocalBlend& u, const LocalBlend& v, const Eigen::Affine3d& m00, const Eigen::Affine3d& m01,
                   const Eigen::Affine3d& m10, const Eigen::Affine3d& m11, const SurfaceJet& p) {
  // Weighted sums and not "first plus weight times difference": a weight of exactly 0 or 1 must select exactly.
  std::array<Matrix34, 3> row0, row1;
  for (std::size_t k = 0; k < 3; ++k) {
    row0[k] = v.one[k] * m00.matrix().topRows<3>() + v.other[k] * m01.matrix().topRows<3>();
    row1[k] = v.one[k] * m10.matrix().topRows<3>() + v.other[k] * m11.matrix().topRows<3>();
  }
  const auto map = [&](std::size_t order_u, std::size_t order_v) -> Matrix34 {
    return u.one[order_u] * row0[order_v] + u.other[order_u] * row1[order_v];
  };
  const Matrix34 a = map(0, 0), a_u = map(1, 0), a_v = map(0, 1);
  const Matrix34 a_uu = map(2, 0), a_uv = map(1, 1), a_vv = map(0, 2);
  const auto point = [&](const Matrix34& m) -> Eigen::Vector3d { return m.leftCols<3>() * p.s + m.col(3); };
  const auto vector = [](const Matrix34& m, const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return m.leftCols<3>() * x;
  };
  SurfaceJet jet;
  jet.s = point(a);
  jet.su = point(a_u) + vector(a, p.su);
  jet.sv = point(a_v) + vector(a, p.sv);
  jet.suu = point(a_uu) + 2 * vector(a_u, p.su) + vector(a, p.suu);
  jet.suv = point(a_uv) + vector(a_u, p.sv) + vector(a_v, p.su) + vector(a, p.suv);
  jet.svv = point(a_vv) + 2 * vector(a_v, p.sv) + vector(a, p.svv);
  return jet;
}

/// How far the image of a knot may be from a knot, relative to the domain: rounding, no more.
constexpr double mirror_tolerance = 1e-9;

/// rho(k) = mirror - k when w -> reflection - w maps the centres of the locals onto each other.
std::optional<int> mirror_of(const KnotVector& knots, double reflection) {
  const int n = knots.count();
  const auto meets = [&](int k, int image) {
    double gap = reflection - knots[k + 1] - knots[image + 1];
    if (knots.closed()) gap = std::remainder(gap, knots.period());
    return std::abs(gap) <= mirror_tolerance * knots.period();
  };
  for (int mirror = knots.closed() ? 0 : n - 1; mirror < n; ++mirror) {
    bool maps = true;
    for (int k = 0; maps && k < n; ++k) maps = meets(k, (mirror - k + n) % n);
    if (maps) return mirror;
  }
  return std::nullopt;
}

/// The twist of a closed direction that reflects the other one.
Result<BlendingSurface::Twist> twist_of(const ModelSurface& model, const char* direction, double reflection,
                                        const Interval& range, Closure closure, const KnotVector& reflected,
                                        const char* path) {
  if (closure == Closure::closed) {
    // Of all periods' reflections the one that keeps nearest to the domain: open knots do not wrap.
    const double own = range.start + range.end;
    reflection = own + std::remainder(reflection - own, range.end - range.start);
  }
  const std::optional<int> mirror = mirror_of(reflected, reflection);
  if (mirror) return BlendingSurface::Twist{reflection, *mirror};
  return Error{path, "Going round the " + std::string(model_name(model)) + " in " + direction +
                         " reflects these knots: they must be symmetric."};
}

/// As often round the closed direction as from t to `reduced`: an odd number of times?
bool odd_turns(const KnotVector& knots, double t, double reduced) {
  return std::fmod(std::round((t - reduced) / knots.period()), 2) != 0;
}

/// The partials of S(-u, v) from those of S.
void mirror_in_u(SurfaceJet& jet) {
  jet.su = -jet.su;
  jet.suv = -jet.suv;
}
void mirror_in_v(SurfaceJet& jet) {
  jet.sv = -jet.sv;
  jet.suv = -jet.suv;
}

/// A reflected parameter, brought by whole periods to where the local of that index is.
double near_centre(const KnotVector& knots, int local, double t) {
  const double centre = knots[local + 1];
  return knots.closed() ? centre + std::remainder(t - centre, knots.period()) : t;
}

/// Adds bu bv s with the product rule.
void add_weighted(SurfaceJet& sum, const std::array<double, 4>& bu, const std::array<double, 4>& bv,
                  const SurfaceJet& s) {
  sum.s += bu[0] * bv[0] * s.s;
  sum.su += bv[0] * (bu[1] * s.s + bu[0] * s.su);
  sum.sv += bu[0] * (bv[1] * s.s + bv[0] * s.sv);
  sum.suu += bv[0] * (bu[2] * s.s + 2 * bu[1] * s.su + bu[0] * s.suu);
  sum.suv += bu[1] * bv[1] * s.s + bu[1] * bv[0] * s.sv + bu[0] * bv[1] * s.su + bu[0] * bv[0] * s.suv;
  sum.svv += bu[0] * (bv[2] * s.s + 2 * bv[1] * s.sv + bv[0] * s.svv);
}

SurfaceJet mapped(const Eigen::Affine3d& map, const SurfaceJet& p) {
  const auto linear = map.linear();
  return {map * p.s, linear * p.su, linear * p.sv, linear * p.suu, linear * p.suv, linear * p.svv};
}

/// sum c[p (degree_v+1) + q] x^p y^q and its partials, by Horner's rule in both directions.
SurfaceJet polynomial_jet(std::span<const Eigen::Vector3d> c, int degree_u, int degree_v, double x, double y) {
  SurfaceJet sum;
  for (int p = degree_u; p >= 0; --p) {
    Eigen::Vector3d f = Eigen::Vector3d::Zero(), f_v = f, f_vv = f;
    for (int q = degree_v; q >= 0; --q) {
      f_vv = y * f_vv + 2 * f_v;
      f_v = y * f_v + f;
      f = y * f + c[static_cast<std::size_t>(p * (degree_v + 1) + q)];
    }
    sum.suu = x * sum.suu + 2 * sum.su;
    sum.su = x * sum.su + sum.s;
    sum.suv = x * sum.suv + sum.sv;
    sum.s = x * sum.s + f;
    sum.sv = x * sum.sv + f_v;
    sum.svv = x * sum.svv + f_vv;
  }
  return sum;
}

}  // namespace

BlendingSurface::BlendingSurface(ModelSurface model, KnotVector knots_u, KnotVector knots_v, BlendingFunction blending,
                                 std::vector<Eigen::Affine3d> locals, LocalSurfaces shape, std::optional<Twist> twist_u,
                                 std::optional<Twist> twist_v)
    : model_(model),
      knots_u_(std::move(knots_u)),
      knots_v_(std::move(knots_v)),
      blending_(std::move(blending)),
      shape_(shape),
      twist_u_(twist_u),
      twist_v_(twist_v),
      locals_(std::move(locals)),
      model_maps_(locals_.size()) {
  centre_jets_.reserve(locals_.size());
  for (int i = 0; i < knots_u_.count(); ++i) {
    for (int j = 0; j < knots_v_.count(); ++j) {
      centre_jets_.push_back(knotwork::evaluate(model_, knots_u_[i + 1], knots_v_[j + 1]));
      set_local(i, j, locals_[index(i, j)]);
    }
  }
  if (shape_.kind == LocalSurfaceKind::bezier_hermite) expand_model();
}

/// The Taylor polynomials of the model at the centres, which depend on no map.
void BlendingSurface::expand_model() {
  const std::size_t kept = static_cast<std::size_t>((shape_.degree_u + 1) * (shape_.degree_v + 1));
  coefficients_.resize(kept * locals_.size());
  constexpr double factorials[] = {1, 1, 2, 6};
  static_assert(std::size(factorials) == max_mixed_order + 1);
  for (int i = 0; i < knots_u_.count(); ++i) {
    for (int j = 0; j < knots_v_.count(); ++j) {
      const std::span<Eigen::Vector3d> own = std::span(coefficients_).subspan(kept * index(i, j), kept);
      mixed_partials(model_, knots_u_[i + 1], knots_v_[j + 1], shape_.degree_u, shape_.degree_v, own);
      own[0].setZero();
      for (std::size_t k = 0; k < kept; ++k) {
        const std::size_t columns = static_cast<std::size_t>(shape_.degree_v) + 1;
        own[k] /= factorials[k / columns] * factorials[k % columns];
      }
    }
  }
}

Result<BlendingSurface> BlendingSurface::make(ModelSurface model, KnotVector knots_u, KnotVector knots_v,
                                              BlendingFunction blending, std::vector<Eigen::Affine3d> locals,
                                              LocalSurfaces shape) {
  if (const Status valid = validate(model); !valid) {
    return Error{"model." + valid.error().path, valid.error().message};
  }
  const SurfaceDomain where = domain(model);
  const auto check = [&](const char* path, const char* letter, const KnotVector& knots, const Interval& range,
                         Closure closure) {
    return check_blending_knots(path, knots,
                                {model_name(model), "surface", letter, range.start, range.end,
                                 closure == Closure::open ? Topology::open : Topology::closed});
  };
  if (const Status ok = check("knots_u", "u", knots_u, where.u, where.closure_u); !ok) return ok.error();
  if (const Status ok = check("knots_v", "v", knots_v, where.v, where.closure_v); !ok) return ok.error();
  std::optional<Twist> twist_u, twist_v;
  if (knots_u.closed() && where.closure_u == Closure::twisted) {
    const Result<Twist> twist = twist_of(model, "u", where.reflection_u, where.v, where.closure_v, knots_v, "knots_v");
    if (!twist) return twist.error();
    twist_u = twist.value();
  }
  if (knots_v.closed() && where.closure_v == Closure::twisted) {
    const Result<Twist> twist = twist_of(model, "v", where.reflection_v, where.u, where.closure_u, knots_u, "knots_u");
    if (!twist) return twist.error();
    twist_v = twist.value();
  }
  if ((twist_u || twist_v) && !blending.symmetric()) {
    return Error{"blending", "A twisted seam needs a symmetric B-function, B(t) + B(1-t) = 1."};
  }
  if (shape.kind == LocalSurfaceKind::bezier_hermite) {
    const auto check_degree = [](const char* path, int degree) -> Status {
      if (degree >= 1 && degree <= max_mixed_order) return success();
      return Error{
          path, "The degree of a local Bézier patch must lie between 1 and " + std::to_string(max_mixed_order) + "."};
    };
    if (const Status ok = check_degree("shape.degree_u", shape.degree_u); !ok) return ok.error();
    if (const Status ok = check_degree("shape.degree_v", shape.degree_v); !ok) return ok.error();
  }
  const std::size_t expected = static_cast<std::size_t>(knots_u.count()) * static_cast<std::size_t>(knots_v.count());
  if (const Status ok = check_local_maps(locals, expected, "surface"); !ok) return ok.error();
  return BlendingSurface(model, std::move(knots_u), std::move(knots_v), std::move(blending), std::move(locals), shape,
                         twist_u, twist_v);
}

std::vector<Eigen::Affine3d> BlendingSurface::unmoved_locals(const ModelSurface& model, const KnotVector& knots_u,
                                                             const KnotVector& knots_v) {
  std::vector<Eigen::Affine3d> locals;
  locals.reserve(static_cast<std::size_t>(knots_u.count()) * static_cast<std::size_t>(knots_v.count()));
  for (int i = 0; i < knots_u.count(); ++i) {
    for (int j = 0; j < knots_v.count(); ++j) {
      locals.emplace_back(Eigen::Translation3d(knotwork::evaluate(model, knots_u[i + 1], knots_v[j + 1]).s));
    }
  }
  return locals;
}

std::size_t BlendingSurface::index(int i, int j) const {
  assert(i >= 0 && i < knots_u_.count() && j >= 0 && j < knots_v_.count());
  return static_cast<std::size_t>(i) * static_cast<std::size_t>(knots_v_.count()) + static_cast<std::size_t>(j);
}

const Eigen::Affine3d& BlendingSurface::local(int i, int j) const { return locals_[index(i, j)]; }

void BlendingSurface::set_local(int i, int j, const Eigen::Affine3d& map) {
  assert(usable_local_map(map));
  locals_[index(i, j)] = map;
  model_maps_[index(i, j)] = map * Eigen::Translation3d(-centre_jet(i, j).s);
}

const Eigen::Affine3d& BlendingSurface::model_map(int i, int j) const { return model_maps_[index(i, j)]; }

std::span<const Eigen::Vector3d> BlendingSurface::coefficients(int i, int j) const {
  const std::size_t kept = coefficients_.size() / locals_.size();
  return std::span(coefficients_).subspan(kept * index(i, j), kept);
}

Eigen::Vector2d BlendingSurface::centre(int i, int j) const { return {knots_u_[i + 1], knots_v_[j + 1]}; }

std::pair<int, int> BlendingSurface::wrapped(int i, int j) const {
  const int n_u = knots_u_.count(), n_v = knots_v_.count();
  assert(i >= 0 && i <= n_u && j >= 0 && j <= n_v);
  int own_i = i == n_u ? 0 : i, own_j = j == n_v ? 0 : j;
  if (i == n_u && twist_u_) own_j = (twist_u_->mirror - own_j + n_v) % n_v;
  if (j == n_v && twist_v_) own_i = (twist_v_->mirror - own_i + n_u) % n_u;
  return {own_i, own_j};
}

const Eigen::Affine3d& BlendingSurface::wrapped_map(int i, int j) const {
  const auto [own_i, own_j] = wrapped(i, j);
  return model_map(own_i, own_j);
}

BlendingSurface::Place BlendingSurface::reduced(double u, double v) const {
  Place place{knots_u_.reduced(u), knots_v_.reduced(v)};
  // No model is twisted in both directions.
  if (twist_u_ && odd_turns(knots_u_, u, place.u)) {
    place.v = knots_v_.reduced(twist_u_->reflection - place.v);
    place.mirrored_v = true;
  } else if (twist_v_ && odd_turns(knots_v_, v, place.v)) {
    place.u = knots_u_.reduced(twist_v_->reflection - place.u);
    place.mirrored_u = true;
  }
  return place;
}

/// s_ij of a Bezier-Hermite local at its centre plus (x, y).
SurfaceJet BlendingSurface::polynomial(int i, int j, double x, double y) const {
  return mapped(local(i, j), polynomial_jet(coefficients(i, j), shape_.degree_u, shape_.degree_v, x, y));
}

SurfaceJet BlendingSurface::evaluate_local(int i, int j, double u, double v) const {
  if (shape_.kind == LocalSurfaceKind::bezier_hermite)
    return polynomial(i, j, u - knots_u_[i + 1], v - knots_v_[j + 1]);
  SurfaceJet p = knotwork::evaluate(model_, u, v);
  p.s -= centre_jet(i, j).s;
  return mapped(local(i, j), p);
}

SurfaceJet BlendingSurface::evaluate(double u, double v) const {
  if (twist_u_ || twist_v_) return evaluate_twisted(u, v);
  SurfaceJet jet;
  evaluate_grid({&u, 1}, {&v, 1}, {&jet, 1});
  return jet;
}

void BlendingSurface::evaluate(std::span<const Eigen::Vector2d> uv, std::span<SurfaceJet> out) const {
  assert(uv.size() == out.size());
  for (std::size_t k = 0; k < uv.size(); ++k) out[k] = evaluate(uv[k].x(), uv[k].y());
}

// The wrapped local of a closed direction is local 0 one period earlier, s_0(u-P). The one-evaluation form applies
// M^_0 to model(u) instead: the same, because the model repeats, model(u-P) = model(u), wherever closing is allowed. So
// it is with a twist, where the model's point at (sigma(u), v-P) is that at (u, v): only the map is another local's.
SurfaceJet BlendingSurface::evaluate_cell(const LocalBlend& u, const LocalBlend& v, const SurfaceJet& model) const {
  return blended(u, v, wrapped_map(u.first, v.first), wrapped_map(u.first, v.first + 1),
                 wrapped_map(u.first + 1, v.first), wrapped_map(u.first + 1, v.first + 1), model);
}

/// Bezier-Hermite locals. Seen from the knots at either end of the interval, a wrapped local needs no special care but
/// that of a twist: it sees the other parameter from the other side.
SurfaceJet BlendingSurface::blended_polynomials(const LocalBlend& u, const LocalBlend& v, double at_u,
                                                double at_v) const {
  SurfaceJet sum;
  for (int a = 0; a <= 1; ++a) {
    for (int b = 0; b <= 1; ++b) {
      const int i = u.first + a, j = v.first + b;
      const bool mirrored_v = twist_u_ && i == knots_u_.count(), mirrored_u = twist_v_ && j == knots_v_.count();
      const double x = at_u - knots_u_[i + 1], y = at_v - knots_v_[j + 1];
      const auto [own_i, own_j] = wrapped(i, j);
      SurfaceJet s = polynomial(own_i, own_j, mirrored_u ? -x : x, mirrored_v ? -y : y);
      if (mirrored_u) mirror_in_u(s);
      if (mirrored_v) mirror_in_v(s);
      add_weighted(sum, a == 0 ? u.one : u.other, b == 0 ? v.one : v.other, s);
    }
  }
  return sum;
}

/// evaluate() where one parameter's turn reflects the other one, so that no row or column stays together.
SurfaceJet BlendingSurface::evaluate_twisted(double u, double v) const {
  const Place at = reduced(u, v);
  const LocalBlend blend_u = local_blend(knots_u_, blending_, at.u, 1);
  const LocalBlend blend_v = local_blend(knots_v_, blending_, at.v, 1);
  SurfaceJet jet = shape_.kind == LocalSurfaceKind::bezier_hermite
                       ? blended_polynomials(blend_u, blend_v, at.u, at.v)
                       : evaluate_cell(blend_u, blend_v, knotwork::evaluate(model_, at.u, at.v));
  if (at.mirrored_u) mirror_in_u(jet);
  if (at.mirrored_v) mirror_in_v(jet);
  return jet;
}

void BlendingSurface::evaluate_grid(std::span<const double> u, std::span<const double> v,
                                    std::span<SurfaceJet> out) const {
  assert(out.size() == u.size() * v.size());
  if (twist_u_ || twist_v_) {
    for (std::size_t a = 0; a < u.size(); ++a) {
      for (std::size_t b = 0; b < v.size(); ++b) out[a * v.size() + b] = evaluate_twisted(u[a], v[b]);
    }
    return;
  }
  // v in blocks on the stack: no allocation, and B once a column and once a row and block.
  constexpr std::size_t block = 64;
  std::array<LocalBlend, block> blends_v;
  std::array<double, block> reduced_v;
  for (std::size_t first = 0; first < v.size(); first += block) {
    const std::size_t size = std::min(block, v.size() - first);
    for (std::size_t b = 0; b < size; ++b) {
      reduced_v[b] = knots_v_.reduced(v[first + b]);
      blends_v[b] = local_blend(knots_v_, blending_, reduced_v[b], b > 0 ? blends_v[b - 1].span() : 1);
    }
    int hint_u = 1;
    for (std::size_t a = 0; a < u.size(); ++a) {
      const double reduced_u = knots_u_.reduced(u[a]);
      const LocalBlend blend_u = local_blend(knots_u_, blending_, reduced_u, hint_u);
      hint_u = blend_u.span();
      const std::span<SurfaceJet> row = out.subspan(a * v.size() + first, size);
      if (shape_.kind == LocalSurfaceKind::bezier_hermite) {
        for (std::size_t b = 0; b < size; ++b) {
          row[b] = blended_polynomials(blend_u, blends_v[b], reduced_u, reduced_v[b]);
        }
        continue;
      }
      knotwork::evaluate_grid(model_, {&reduced_u, 1}, std::span(reduced_v).first(size), row);
      for (std::size_t b = 0; b < size; ++b) row[b] = evaluate_cell(blend_u, blends_v[b], row[b]);
    }
  }
}

SurfaceJet BlendingSurface::evaluate_four_patches(double u, double v) const {
  const Place at = reduced(u, v);
  const int i = knots_u_.span(at.u), j = knots_v_.span(at.v);
  const LocalBlend blend_u = local_blend(knots_u_, blending_, at.u, i);
  const LocalBlend blend_v = local_blend(knots_v_, blending_, at.v, j);
  SurfaceJet sum;
  for (int a = 0; a <= 1; ++a) {
    for (int b = 0; b <= 1; ++b) {
      const bool wraps_u = i - 1 + a == knots_u_.count(), wraps_v = j - 1 + b == knots_v_.count();
      const auto [own_i, own_j] = wrapped(i - 1 + a, j - 1 + b);
      double own_u = wraps_u ? at.u - knots_u_.period() : at.u;
      double own_v = wraps_v ? at.v - knots_v_.period() : at.v;
      if (wraps_u && twist_u_) own_v = near_centre(knots_v_, own_j, twist_u_->reflection - own_v);
      if (wraps_v && twist_v_) own_u = near_centre(knots_u_, own_i, twist_v_->reflection - own_u);
      SurfaceJet s = evaluate_local(own_i, own_j, own_u, own_v);
      if (wraps_u && twist_u_) mirror_in_v(s);
      if (wraps_v && twist_v_) mirror_in_u(s);
      add_weighted(sum, a == 0 ? blend_u.one : blend_u.other, b == 0 ? blend_v.one : blend_v.other, s);
    }
  }
  if (at.mirrored_u) mirror_in_u(sum);
  if (at.mirrored_v) mirror_in_v(sum);
  return sum;
}

std::array<BlendingSurface::Weight, 4> BlendingSurface::weights(double u, double v) const {
  const Place at = reduced(u, v);
  const LocalBlend x = local_blend(knots_u_, blending_, at.u, 1), y = local_blend(knots_v_, blending_, at.v, 1);
  const auto weight = [&](int a, int b) -> Weight {
    const auto [i, j] = wrapped(x.first + a, y.first + b);
    return {i, j, (a == 0 ? x.one : x.other)[0] * (b == 0 ? y.one : y.other)[0]};
  };
  return {weight(0, 0), weight(0, 1), weight(1, 0), weight(1, 1)};
}

}  // namespace knotwork
