#include "knotwork/surface/blending_surface.h"

#include <algorithm>
#include <cassert>

#include "knotwork/basis/local_blend.h"

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

Eigen::Vector3d model_origin(const ModelSurface& model, const KnotVector& knots_u, const KnotVector& knots_v, int i,
                             int j) {
  return evaluate(model, knots_u[i + 1], knots_v[j + 1]).s;
}

}  // namespace

BlendingSurface::BlendingSurface(ModelSurface model, KnotVector knots_u, KnotVector knots_v, BlendingFunction blending,
                                 std::vector<Eigen::Affine3d> locals)
    : model_(std::move(model)),
      knots_u_(std::move(knots_u)),
      knots_v_(std::move(knots_v)),
      blending_(std::move(blending)),
      locals_(std::move(locals)),
      model_maps_(locals_.size()) {
  for (int i = 0; i < knots_u_.count(); ++i) {
    for (int j = 0; j < knots_v_.count(); ++j) set_local(i, j, locals_[index(i, j)]);
  }
}

Result<BlendingSurface> BlendingSurface::make(ModelSurface model, KnotVector knots_u, KnotVector knots_v,
                                              BlendingFunction blending, std::vector<Eigen::Affine3d> locals) {
  if (const Status valid = validate(model); !valid) {
    return Error{"model." + valid.error().path, valid.error().message};
  }
  const SurfaceDomain where = domain(model);
  const auto check = [&](const char* path, const char* letter, const KnotVector& knots, const Interval& range,
                         Topology closure) {
    return check_blending_knots(path, knots, {model_name(model), "surface", letter, range.start, range.end, closure});
  };
  if (const Status ok = check("knots_u", "u", knots_u, where.u, where.closure_u); !ok) return ok.error();
  if (const Status ok = check("knots_v", "v", knots_v, where.v, where.closure_v); !ok) return ok.error();
  const std::size_t expected = static_cast<std::size_t>(knots_u.count()) * static_cast<std::size_t>(knots_v.count());
  if (const Status ok = check_local_maps(locals, expected, "surface"); !ok) return ok.error();
  return BlendingSurface(std::move(model), std::move(knots_u), std::move(knots_v), std::move(blending),
                         std::move(locals));
}

std::vector<Eigen::Affine3d> BlendingSurface::unmoved_locals(const ModelSurface& model, const KnotVector& knots_u,
                                                             const KnotVector& knots_v) {
  std::vector<Eigen::Affine3d> locals;
  locals.reserve(static_cast<std::size_t>(knots_u.count()) * static_cast<std::size_t>(knots_v.count()));
  for (int i = 0; i < knots_u.count(); ++i) {
    for (int j = 0; j < knots_v.count(); ++j) {
      locals.emplace_back(Eigen::Translation3d(model_origin(model, knots_u, knots_v, i, j)));
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
  model_maps_[index(i, j)] = map * Eigen::Translation3d(-model_origin(model_, knots_u_, knots_v_, i, j));
}

const Eigen::Affine3d& BlendingSurface::model_map(int i, int j) const { return model_maps_[index(i, j)]; }

Eigen::Vector2d BlendingSurface::centre(int i, int j) const { return {knots_u_[i + 1], knots_v_[j + 1]}; }

SurfaceJet BlendingSurface::evaluate_local(int i, int j, double u, double v) const {
  const SurfaceJet p = knotwork::evaluate(model_, u, v);
  const Eigen::Affine3d& m = local(i, j);
  const auto linear = m.linear();
  return {m * (p.s - model_origin(model_, knots_u_, knots_v_, i, j)),
          linear * p.su,
          linear * p.sv,
          linear * p.suu,
          linear * p.suv,
          linear * p.svv};
}

SurfaceJet BlendingSurface::evaluate(double u, double v) const {
  SurfaceJet jet;
  evaluate_grid({&u, 1}, {&v, 1}, {&jet, 1});
  return jet;
}

void BlendingSurface::evaluate(std::span<const Eigen::Vector2d> uv, std::span<SurfaceJet> out) const {
  assert(uv.size() == out.size());
  for (std::size_t k = 0; k < uv.size(); ++k) out[k] = evaluate(uv[k].x(), uv[k].y());
}

// The wrapped local of a closed direction is local 0 one period earlier, s_0(u-P). The one-evaluation form applies
// M^_0 to model(u) instead: the same, because the model repeats, model(u-P) = model(u), wherever closing is allowed.
void BlendingSurface::evaluate_grid(std::span<const double> u, std::span<const double> v,
                                    std::span<SurfaceJet> out) const {
  assert(out.size() == u.size() * v.size());
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
      knotwork::evaluate_grid(model_, {&reduced_u, 1}, std::span(reduced_v).first(size), row);
      for (std::size_t b = 0; b < size; ++b) {
        const LocalBlend& blend_v = blends_v[b];
        row[b] =
            blended(blend_u, blend_v, model_map(blend_u.first, blend_v.first), model_map(blend_u.first, blend_v.second),
                    model_map(blend_u.second, blend_v.first), model_map(blend_u.second, blend_v.second), row[b]);
      }
    }
  }
}

SurfaceJet BlendingSurface::evaluate_four_patches(double u, double v) const {
  const double reduced_u = knots_u_.reduced(u), reduced_v = knots_v_.reduced(v);
  const int i = knots_u_.span(reduced_u), j = knots_v_.span(reduced_v);
  const LocalBlend blend_u = local_blend(knots_u_, blending_, reduced_u, i);
  const LocalBlend blend_v = local_blend(knots_v_, blending_, reduced_v, j);
  SurfaceJet sum;
  for (int a = 0; a <= 1; ++a) {
    for (int b = 0; b <= 1; ++b) {
      const bool wraps_u = i - 1 + a == knots_u_.count(), wraps_v = j - 1 + b == knots_v_.count();
      const SurfaceJet s = evaluate_local(wraps_u ? 0 : i - 1 + a, wraps_v ? 0 : j - 1 + b,
                                          wraps_u ? reduced_u - knots_u_.period() : reduced_u,
                                          wraps_v ? reduced_v - knots_v_.period() : reduced_v);
      const std::array<double, 4>& bu = a == 0 ? blend_u.one : blend_u.other;
      const std::array<double, 4>& bv = b == 0 ? blend_v.one : blend_v.other;
      sum.s += bu[0] * bv[0] * s.s;
      sum.su += bv[0] * (bu[1] * s.s + bu[0] * s.su);
      sum.sv += bu[0] * (bv[1] * s.s + bv[0] * s.sv);
      sum.suu += bv[0] * (bu[2] * s.s + 2 * bu[1] * s.su + bu[0] * s.suu);
      sum.suv += bu[1] * bv[1] * s.s + bu[1] * bv[0] * s.sv + bu[0] * bv[1] * s.su + bu[0] * bv[0] * s.suv;
      sum.svv += bu[0] * (bv[2] * s.s + 2 * bv[1] * s.sv + bv[0] * s.svv);
    }
  }
  return sum;
}

std::array<BlendingSurface::Weight, 4> BlendingSurface::weights(double u, double v) const {
  const double reduced_u = knots_u_.reduced(u), reduced_v = knots_v_.reduced(v);
  const LocalBlend a = local_blend(knots_u_, blending_, reduced_u, knots_u_.span(reduced_u));
  const LocalBlend b = local_blend(knots_v_, blending_, reduced_v, knots_v_.span(reduced_v));
  return {{{a.first, b.first, a.one[0] * b.one[0]},
           {a.first, b.second, a.one[0] * b.other[0]},
           {a.second, b.first, a.other[0] * b.one[0]},
           {a.second, b.second, a.other[0] * b.other[0]}}};
}

}  // namespace knotwork
