#include <memory>

#include "benchmark/kernel.h"
#include "knotwork/surface/bezier_surface.h"
#include "knotwork/surface/blending_surface.h"
#include "knotwork/surface/bspline_surface.h"
#include "knotwork/surface/surface_catalogue.h"

namespace knotwork::benchmark {
namespace {

constexpr std::size_t side = 60;

/// max over the six vectors of the jets, each relative to its own size.
double difference_of_jets(const std::vector<SurfaceJet>& actual, const std::vector<SurfaceJet>& expected) {
  double worst = 0;
  for (const auto part :
       {&SurfaceJet::s, &SurfaceJet::su, &SurfaceJet::sv, &SurfaceJet::suu, &SurfaceJet::suv, &SurfaceJet::svv}) {
    std::vector<Eigen::Vector3d> left, right;
    for (const SurfaceJet& jet : actual) left.push_back(jet.*part);
    for (const SurfaceJet& jet : expected) right.push_back(jet.*part);
    worst = std::max(worst, difference(left, right));
  }
  return worst;
}

/// A grid and single points against a reference for one point.
template <class Grid, class Single, class Reference>
void add_grid_and_single(std::vector<Kernel>& rows, const std::string& name, const std::vector<double>& u,
                         const std::vector<double>& v, const Grid& grid, const Single& single,
                         const Reference& reference) {
  const auto out = std::make_shared<std::vector<SurfaceJet>>(u.size() * v.size());
  const auto error = [=] {
    std::vector<SurfaceJet> expected;
    for (const double a : u) {
      for (const double b : v) expected.push_back(reference(a, b));
    }
    return difference_of_jets(*out, expected);
  };
  rows.push_back({name + ", grid", out->size(), [=] { grid(u, v, *out); }, error});
  const auto one_by_one = [=] {
    std::size_t k = 0;
    for (const double a : u) {
      for (const double b : v) (*out)[k++] = single(a, b);
    }
  };
  rows.push_back({name + ", single", out->size(), one_by_one, error});
}

/// Partials of a spline surface from its isoparametric curves.
SurfaceJet from_curves(const BSplineSurface& surface, double u, double v) {
  SurfaceJet jet;
  std::vector<Eigen::Vector3d> along_u(3), along_v(3), rows;
  surface.curve_u(v).evaluate(u, along_u);
  surface.curve_v(u).evaluate(v, along_v);
  // S_uv: the curve in u whose points are the derivatives by v of the rows.
  for (int i = 0; i < surface.knots_u().count(); ++i) {
    std::vector<Eigen::Vector3d> row, derivatives(2);
    for (int j = 0; j < surface.knots_v().count(); ++j) row.push_back(surface.point(i, j));
    BSplineCurve::make(surface.knots_v(), row).value().evaluate(v, derivatives);
    rows.push_back(derivatives[1]);
  }
  std::vector<Eigen::Vector3d> mixed(2);
  BSplineCurve::make(surface.knots_u(), rows).value().evaluate(u, mixed);
  jet.s = along_u[0], jet.su = along_u[1], jet.suu = along_u[2], jet.sv = along_v[1], jet.svv = along_v[2];
  jet.suv = mixed[1];
  return jet;
}

void add_spline_surface(std::vector<Kernel>& rows, const std::string& name, const BSplineSurface& surface) {
  const KnotVector &u = surface.knots_u(), &v = surface.knots_v();
  add_grid_and_single(
      rows, name, parameters(u.start(), u.end(), side), parameters(v.start(), v.end(), side),
      [=](const auto& a, const auto& b, auto& out) { surface.evaluate_grid(a, b, out); },
      [=](double a, double b) { return surface.evaluate(a, b); },
      [=](double a, double b) { return from_curves(surface, a, b); });
}

void add_blending_surface(std::vector<Kernel>& rows, BlendingKind kind) {
  const ModelSurface model = Sheet{};  // rolled up, a torus
  const auto over = domain(model);
  const KnotVector u = KnotVector::uniform(1, 6, Topology::closed, over.u.start, over.u.end).value();
  const KnotVector v = KnotVector::uniform(1, 4, Topology::closed, over.v.start, over.v.end).value();
  BlendingSurface surface = BlendingSurface::make(model, u, v, BlendingFunction::make(kind).value(),
                                                  BlendingSurface::unmoved_locals(model, u, v))
                                .value();
  surface.set_local(2, 1, Eigen::Translation3d(0, 0, 0.5) * surface.local(2, 1));
  add_grid_and_single(
      rows, "blending surface, " + std::string(blending_family(kind).id), parameters(u.start(), u.end(), side),
      parameters(v.start(), v.end(), side),
      [=](const auto& a, const auto& b, auto& out) { surface.evaluate_grid(a, b, out); },
      [=](double a, double b) { return surface.evaluate(a, b); },
      [=](double a, double b) { return surface.evaluate_four_patches(a, b); });
}

/// The grid against single points: the formulas themselves are held to oracle 09.
void add_catalogue_surface(std::vector<Kernel>& rows, const char* id) {
  const CatalogueSurface surface = make_catalogue_surface(id).value();
  const auto where = domain(surface);
  const auto at = [=](double u, double v) { return evaluate(surface, u, v); };
  add_grid_and_single(
      rows, "catalogue surface, " + std::string(id), parameters(where.u.start, where.u.end, side),
      parameters(where.v.start, where.v.end, side),
      [=](const auto& u, const auto& v, auto& out) { evaluate_grid(surface, u, v, out); }, at, at);
}

}  // namespace

std::vector<Kernel> surface_kernels() {
  std::vector<Kernel> rows;
  const KnotVector u = KnotVector::uniform(3, 20, Topology::closed, 0, 1).value();
  const KnotVector v = KnotVector::uniform(3, 20, Topology::open, 0, 1).value();
  add_spline_surface(rows, "bspline surface, bicubic, 20 x 20", BSplineSurface::make(u, v, wavy_points(400)).value());
  add_spline_surface(rows, "bezier surface, bicubic", BezierSurface::make(3, 3, wavy_points(16)).value().spline());
  add_blending_surface(rows, BlendingKind::polynomial2);
  add_blending_surface(rows, BlendingKind::expo_rational);
  for (const char* id : {"torus", "boy", "seashell"}) add_catalogue_surface(rows, id);
  return rows;
}

}  // namespace knotwork::benchmark
