// OpenCASCADE's adaptors, which keep the polynomial of the span that they were in last.

#include <memory>

#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "benchmark/rivals.h"
#include "benchmark/works.h"

namespace knotwork::benchmark {
namespace {

constexpr int degree = 3;

/// Distinct knots and how often they stand there.
struct Knots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger multiplicities;

  explicit Knots(const KnotVector& knots)
      : values(1, knots.interval_count() + 1), multiplicities(1, knots.interval_count() + 1) {
    for (int k = 1; k <= values.Size(); ++k) {
      values(k) = knots[k + degree - 1];
      multiplicities(k) = k == 1 || k == values.Size() ? degree + 1 : 1;
    }
  }
};

gp_Pnt point(const Eigen::Vector3d& c) { return {c.x(), c.y(), c.z()}; }
Eigen::Vector3d vector(const gp_XYZ& c) { return {c.X(), c.Y(), c.Z()}; }

void add_curves(std::vector<Kernel>& rows) {
  for (const CurveWork& work : curve_works()) {
    const BSplineCurve curve = work.curve();
    TColgp_Array1OfPnt points(1, curve.knots().count());
    for (int i = 1; i <= points.Size(); ++i) points(i) = point(curve.point(i - 1));
    const Knots knots(curve.knots());
    const Handle(Geom_BSplineCurve) other = new Geom_BSplineCurve(points, knots.values, knots.multiplicities, degree);
    const auto adaptor = std::make_shared<const GeomAdaptor_Curve>(other);
    rows.push_back(curve_contender(work, "OpenCASCADE", [=](std::span<const double> t, Eigen::Vector3d* out) {
      gp_Pnt c;
      gp_Vec d1, d2;
      for (const double at : t) {
        if (work.order == 0) {
          adaptor->D0(at, c);
          *out++ = vector(c.XYZ());
        } else {
          adaptor->D2(at, c, d1, d2);
          *out++ = vector(c.XYZ());
          *out++ = vector(d1.XYZ());
          *out++ = vector(d2.XYZ());
        }
      }
    }));
  }
}

void add_surfaces(std::vector<Kernel>& rows) {
  const BSplineSurface surface = surface_work();
  TColgp_Array2OfPnt points(1, surface.knots_u().count(), 1, surface.knots_v().count());
  for (int i = 0; i < surface.knots_u().count(); ++i) {
    for (int j = 0; j < surface.knots_v().count(); ++j) points(i + 1, j + 1) = point(surface.point(i, j));
  }
  const Knots u(surface.knots_u()), v(surface.knots_v());
  const Handle(Geom_BSplineSurface) other =
      new Geom_BSplineSurface(points, u.values, v.values, u.multiplicities, v.multiplicities, degree, degree);
  const auto adaptor = std::make_shared<const GeomAdaptor_Surface>(other);
  for (const bool frames : {false, true}) {
    const auto work = std::make_shared<const GridWork>(surface_grid(frames));
    const std::size_t side = work->side;
    const auto out = std::make_shared<std::vector<Eigen::Vector3d>>((frames ? 3 : 1) * side * side);
    const auto run = [=] {
      Eigen::Vector3d* to = out->data();
      gp_Pnt s;
      gp_Vec su, sv;
      for (const double a : work->u) {
        for (const double b : work->v) {
          if (frames) {
            adaptor->D1(a, b, s, su, sv);
            *to++ = vector(s.XYZ());
            *to++ = vector(su.XYZ());
            *to++ = vector(sv.XYZ());
          } else {
            adaptor->D0(a, b, s);
            *to++ = vector(s.XYZ());
          }
        }
      }
    };
    const auto at = [=](std::size_t k) {
      Frame frame = Frame::Zero();
      if (!frames) {
        frame.col(0) = (*out)[k];
      } else {
        for (std::size_t c = 0; c < 3; ++c) frame.col(static_cast<Eigen::Index>(c)) = (*out)[3 * k + c];
      }
      return frame;
    };
    constexpr bool normals = false;
    rows.push_back(surface_contender(*work, frames ? "OpenCASCADE, no normal" : "OpenCASCADE", run, at, normals));
  }
}

}  // namespace

void add_opencascade(std::vector<Kernel>& rows) {
  add_curves(rows);
  add_surfaces(rows);
}

}  // namespace knotwork::benchmark
