// The grid of BlendingSurface that is evaluated by the row. Fast because of what a point does not cost: the blending
// function and, for the sheet, the model's sines and cosines are evaluated once a row and once a column of the grid; the
// four maps of a cell become two, blended over u, once a row and cell. What is left, blending those two over v and
// mapping the model's point and partials, is the same arithmetic for all points of a cell: neighbours share one
// instruction.

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "knotwork/basis/lanes.h"
#include "knotwork/basis/local_blend.h"
#include "knotwork/surface/blending_surface.h"
#include "knotwork/surface/frame_columns.h"
#include "knotwork/surface/sheet_formula.h"
#include "knotwork/surface/surface_measures.h"

namespace knotwork {
namespace {

/// One direction of the grid: parameters in the domain and, for each, the locals that meet there with their weights.
struct BlendedLine {
  std::vector<double> t;
  std::vector<LocalBlend> blends;

  BlendedLine(const KnotVector& knots, const BlendingFunction& blending, std::span<const double> parameters) {
    t.reserve(parameters.size());
    blends.reserve(parameters.size());
    int hint = 1;
    for (const double parameter : parameters) {
      t.push_back(knots.reduced(parameter));
      blends.push_back(local_blend(knots, blending, t.back(), hint));
      hint = blends.back().span();
    }
  }
};

/// Weights at the grid's columns, list by list: 1-B, B and the derivative of B by v.
struct WeightColumns {
  std::vector<double> one, other, slope;

  explicit WeightColumns(std::span<const LocalBlend> blends) {
    for (const LocalBlend& blend : blends) {
      one.push_back(blend.one[0]);
      other.push_back(blend.other[0]);
      slope.push_back(blend.other[1]);
    }
    // Whole lanes are read at the end.
    for (std::vector<double>* list : {&one, &other, &slope}) list->resize(blends.size() + lane_count);
  }
};

/// The model's point and first partials along the grid's rows, a few columns at a time.
class ModelRows {
 public:
  ModelRows(const ModelSurface& model, std::span<const double> u, std::span<const double> v)
      : model_(model), u_(u), v_(v) {
    const Sheet* sheet = std::get_if<Sheet>(&model);
    if (sheet == nullptr) return;
    for (const double t : u) along_u_.push_back(sheet_along_u(*sheet, Taylor2::variable_u(t)));
    for (const double t : v) {
      const SheetAlongV<Taylor2> g = sheet_along_v(*sheet, Taylor2::variable_v(t));
      for (std::size_t k = 0; const double value : {g.p.value, g.p.v, g.q.value, g.q.v}) along_v_[k++].push_back(value);
    }
    // Whole lanes are read at the end.
    for (std::vector<double>& list : along_v_) list.resize(v.size() + 2 * lane_count);
  }

  /// Row a at the columns first .. first + count - 1, count <= row_piece; finite beyond.
  void fill(std::size_t a, std::size_t first, std::size_t count, FrameColumns& to) {
    along_u_.empty() ? fill_from_jets(a, first, count, to) : fill_from_factors(a, first, count, to);
  }

 private:
  void fill_from_factors(std::size_t a, std::size_t first, std::size_t count, FrameColumns& to) const {
    const SheetAlongU<Taylor2>& f = along_u_[a];
    for (std::size_t m = 0; m < count + lane_count; m += lane_count) {
      Lanes p, p_v, q, q_v;
      load(p, &along_v_[0][first + m]);
      load(p_v, &along_v_[1][first + m]);
      load(q, &along_v_[2][first + m]);
      load(q_v, &along_v_[3][first + m]);
      store(f.x.value + p * f.cos.value, to.at(FrameColumns::s, m));
      store(f.y.value + p * f.sin.value, to.at(FrameColumns::s + 1, m));
      store(q, to.at(FrameColumns::s + 2, m));
      store(f.x.u + p * f.cos.u, to.at(FrameColumns::su, m));
      store(f.y.u + p * f.sin.u, to.at(FrameColumns::su + 1, m));
      store(Lanes{}, to.at(FrameColumns::su + 2, m));
      store(p_v * f.cos.value, to.at(FrameColumns::sv, m));
      store(p_v * f.sin.value, to.at(FrameColumns::sv + 1, m));
      store(q_v, to.at(FrameColumns::sv + 2, m));
    }
  }

  void fill_from_jets(std::size_t a, std::size_t first, std::size_t count, FrameColumns& to) {
    evaluate_grid(model_, u_.subspan(a, 1), v_.subspan(first, count), std::span(jets_).first(count));
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Index k = static_cast<Eigen::Index>(c);
      for (std::size_t m = 0; m < count; ++m) {
        *to.at(FrameColumns::s + c, m) = jets_[m].s[k];
        *to.at(FrameColumns::su + c, m) = jets_[m].su[k];
        *to.at(FrameColumns::sv + c, m) = jets_[m].sv[k];
      }
      for (const std::size_t part : {FrameColumns::s, FrameColumns::su, FrameColumns::sv})
        std::fill_n(to.at(part + c, count), lane_count, 0.0);
    }
  }

  const ModelSurface& model_;
  std::span<const double> u_, v_;
  std::vector<SheetAlongU<Taylor2>> along_u_;  ///< empty when the model is no sheet
  std::array<std::vector<double>, 4> along_v_;
  std::array<SurfaceJet, row_piece> jets_;
};

/// One row (l_0, l_1, l_2, t) of an affine map: l . x + t.
using MapRow = std::array<double, 4>;
using MapRows = std::array<MapRow, 3>;

/// a m + b n.
MapRows blended_maps(double a, const Eigen::Affine3d& m, double b, const Eigen::Affine3d& n) {
  MapRows rows;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Eigen::Index i = static_cast<Eigen::Index>(r), j = static_cast<Eigen::Index>(k);
      rows[r][k] = a * m(i, j) + b * n(i, j);
    }
  }
  return rows;
}

/// A cell's maps, blended over u at one row of the grid: at its first and at its second knot in v, with derivatives.
struct CellMaps {
  MapRows first, second, first_u, second_u, difference;

  CellMaps(const LocalBlend& u, const Eigen::Affine3d& m00, const Eigen::Affine3d& m01, const Eigen::Affine3d& m10,
           const Eigen::Affine3d& m11)
      : first(blended_maps(u.one[0], m00, u.other[0], m10)),
        second(blended_maps(u.one[0], m01, u.other[0], m11)),
        first_u(blended_maps(u.one[1], m00, u.other[1], m10)),
        second_u(blended_maps(u.one[1], m01, u.other[1], m11)),
        difference(second) {
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t k = 0; k < 4; ++k) difference[r][k] -= first[r][k];
    }
  }
};

/// S = A (x; 1), S_u = A_u (x; 1) + A x_u, S_v = A_v (x; 1) + A x_v at the places begin .. end - 1 of one cell, where A =
/// (1-B) first + B second. Whole lanes at a time.
void map_model(const CellMaps& maps, const WeightColumns& weights, std::size_t first, std::size_t begin,
               std::size_t end, FrameColumns& model, FrameColumns& to) {
  for (std::size_t m = begin; m < end; m += lane_count) {
    Lanes one, other, slope;
    load(one, &weights.one[first + m]);
    load(other, &weights.other[first + m]);
    load(slope, &weights.slope[first + m]);
    Lanes x, y, z, x_u, y_u, z_u, x_v, y_v, z_v;
    load(x, model.at(FrameColumns::s, m));
    load(y, model.at(FrameColumns::s + 1, m));
    load(z, model.at(FrameColumns::s + 2, m));
    load(x_u, model.at(FrameColumns::su, m));
    load(y_u, model.at(FrameColumns::su + 1, m));
    load(z_u, model.at(FrameColumns::su + 2, m));
    load(x_v, model.at(FrameColumns::sv, m));
    load(y_v, model.at(FrameColumns::sv + 1, m));
    load(z_v, model.at(FrameColumns::sv + 2, m));
    for (std::size_t r = 0; r < 3; ++r) {
      const MapRow &p = maps.first[r], &q = maps.second[r], &p_u = maps.first_u[r], &q_u = maps.second_u[r],
                   &d = maps.difference[r];
      // Weighted sums and not "first plus weight times difference": a weight of exactly 0 or 1 must select exactly.
      const Lanes a0 = one * p[0] + other * q[0], a1 = one * p[1] + other * q[1], a2 = one * p[2] + other * q[2];
      const Lanes at = one * p[3] + other * q[3];
      const Lanes mapped_first = p_u[0] * x + p_u[1] * y + p_u[2] * z + p_u[3];
      const Lanes mapped_second = q_u[0] * x + q_u[1] * y + q_u[2] * z + q_u[3];
      const Lanes across = d[0] * x + d[1] * y + d[2] * z + d[3];
      store(a0 * x + a1 * y + a2 * z + at, to.at(FrameColumns::s + r, m));
      store(one * mapped_first + other * mapped_second + (a0 * x_u + a1 * y_u + a2 * z_u),
            to.at(FrameColumns::su + r, m));
      store(slope * across + (a0 * x_v + a1 * y_v + a2 * z_v), to.at(FrameColumns::sv + r, m));
    }
  }
}

}  // namespace

void BlendingSurface::evaluate_grid(std::span<const double> u, std::span<const double> v,
                                    std::span<SurfaceFrame> out) const {
  assert(out.size() == u.size() * v.size());
  if (twist_u_ || twist_v_ || shape_.kind == LocalSurfaceKind::bezier_hermite) {
    for (std::size_t k = 0; k < out.size(); ++k) {
      const SurfaceJet jet = evaluate(u[k / v.size()], v[k % v.size()]);
      out[k] = {jet.s, jet.su, jet.sv, unit_normal(jet)};
    }
    return;
  }
  const BlendedLine line_u(knots_u_, blending_, u), line_v(knots_v_, blending_, v);
  const WeightColumns weights(line_v.blends);
  ModelRows model_rows(model_, line_u.t, line_v.t);
  FrameColumns model, frames;
  for (std::size_t a = 0; a < u.size(); ++a) {
    const LocalBlend& blend = line_u.blends[a];
    for (std::size_t first = 0; first < v.size(); first += row_piece) {
      const std::size_t count = std::min(row_piece, v.size() - first);
      model_rows.fill(a, first, count, model);
      for (std::size_t m = 0; m < count;) {
        const std::size_t begin = m;
        const int i = blend.first, j = line_v.blends[first + m].first;
        while (m < count && line_v.blends[first + m].first == j) ++m;
        const CellMaps maps(blend, wrapped_map(i, j), wrapped_map(i, j + 1), wrapped_map(i + 1, j),
                            wrapped_map(i + 1, j + 1));
        map_model(maps, weights, first, begin, m, model, frames);
      }
      frames.hand_over(out.subspan(a * v.size() + first, count),
                       [&](std::size_t k) { return unit_normal(evaluate(u[a], v[first + k])); });
    }
  }
}

}  // namespace knotwork
