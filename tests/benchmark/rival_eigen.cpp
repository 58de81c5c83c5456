// Eigen's own splines (unsupported/Eigen/Splines): fixed degree, everything on the stack.

#include <memory>

#include <unsupported/Eigen/Splines>

#include "benchmark/rivals.h"
#include "benchmark/works.h"

namespace knotwork::benchmark {

void add_eigen(std::vector<Kernel>& rows) {
  using Spline = Eigen::Spline<double, 3, 3>;
  for (const CurveWork& work : curve_works()) {
    const BSplineCurve curve = work.curve();
    const Eigen::Index n = curve.knots().count();
    Spline::KnotVectorType knots(n + 4);
    for (Eigen::Index k = 0; k < knots.size(); ++k) knots[k] = curve.knots()[static_cast<int>(k)];
    Spline::ControlPointVectorType points(3, n);
    for (Eigen::Index i = 0; i < n; ++i) points.col(i) = curve.point(static_cast<int>(i)).array();
    const auto spline = std::make_shared<const Spline>(knots, points);
    rows.push_back(curve_contender(work, "Eigen Spline", [=](std::span<const double> t, Eigen::Vector3d* out) {
      for (const double at : t) {
        if (work.order == 0) {
          *out++ = (*spline)(at).matrix();
        } else {
          const auto values = spline->derivatives<2>(at);
          for (Eigen::Index k = 0; k <= 2; ++k) *out++ = values.col(k).matrix();
        }
      }
    }));
  }
}

}  // namespace knotwork::benchmark
