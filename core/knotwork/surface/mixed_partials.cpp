#include "knotwork/surface/mixed_partials.h"

#include <cassert>
#include <cstddef>

#include "knotwork/surface/mixed_series.h"
#include "knotwork/surface/sheet_formula.h"

namespace knotwork {
namespace {

static_assert(max_mixed_order == MixedSeries::degree);

PointOf<MixedSeries> series_of(const ModelSurface& model, const MixedSeries& u, const MixedSeries& v) {
  const Sheet* sheet = std::get_if<Sheet>(&model);
  return sheet != nullptr ? sheet_formula(*sheet, u, v) : series_of(*std::get_if<CatalogueSurface>(&model), u, v);
}

}  // namespace

void mixed_partials(const ModelSurface& model, double u, double v, int order_u, int order_v,
                    std::span<Eigen::Vector3d> out) {
  assert(order_u >= 0 && order_u <= max_mixed_order && order_v >= 0 && order_v <= max_mixed_order);
  assert(out.size() == static_cast<std::size_t>((order_u + 1) * (order_v + 1)));
  const PointOf<MixedSeries> series = series_of(model, MixedSeries::variable_u(u), MixedSeries::variable_v(v));
  constexpr double factorials[] = {1, 1, 2, 6};
  std::size_t k = 0;
  for (std::size_t p = 0; p <= static_cast<std::size_t>(order_u); ++p) {
    for (std::size_t q = 0; q <= static_cast<std::size_t>(order_v); ++q) {
      const Eigen::Vector3d coefficient(series.x.coefficient(p, q), series.y.coefficient(p, q),
                                        series.z.coefficient(p, q));
      out[k++] = factorials[p] * factorials[q] * coefficient;
    }
  }
}

}  // namespace knotwork
