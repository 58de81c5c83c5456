#pragma once

#include <span>

#include "knotwork/surface/model_surface.h"

namespace knotwork {

/// The highest order in each direction that mixed partials have.
inline constexpr int max_mixed_order = 3;

/// out[p * (order_v + 1) + q] = D^(p,q) S(u,v), 0 <= p <= order_u, 0 <= q <= order_v, from the model's one formula on
/// double power series; nothing is allocated. u, v are not reduced to the domain. Each to 1e-12 of the largest partial
/// of its order on the domain. Preconditions: orders from 0 to max_mixed_order.
void mixed_partials(const ModelSurface& model, double u, double v, int order_u, int order_v,
                    std::span<Eigen::Vector3d> out);

}  // namespace knotwork
