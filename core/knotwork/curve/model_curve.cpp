#include "knotwork/curve/model_curve.h"

#include "knotwork/basis/bernstein.h"

namespace knotwork {

ModelCurve model_curve(BSplineCurve curve) {
  const KnotVector& knots = curve.knots();
  const double start = knots.start(), end = knots.end();
  const Topology topology = knots.topology();
  // Any order would do; this is the highest degree that a local Bezier curve can have.
  return {start, end, topology, max_bezier_degree,
          [curve = std::move(curve)](double t, std::span<Eigen::Vector3d> out) { curve.evaluate(t, out); }};
}

}  // namespace knotwork
