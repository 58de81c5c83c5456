#pragma once

#include <span>
#include <string_view>

#include "knotwork/basis/interval.h"
#include "knotwork/catalogue_measure.h"
#include "knotwork/surface/surface_domain.h"
#include "knotwork/surface/surface_jet.h"
#include "knotwork/surface/taylor2_point.h"

namespace knotwork {

/// One of a surface's two parameters.
struct CatalogueDirection {
  Interval domain;
  Closure closure = Closure::open;
  /// Twisted: sigma(w) = reflection - w for the other parameter w (where that is closed, up to its period).
  double reflection = 0;
  /// Whether the surface shrinks to one point at that end of the domain, where S_u x S_v is 0. Poles elsewhere (eight
  /// surface, cross-cap, Boy's and Steiner's surface have some inside) are not listed.
  bool pole_at_start = false, pole_at_end = false;
  int unit = -1;  ///< the measure that the domain is to be multiplied by; -1: none
};

class MixedSeries;

/// A formula S(u,v), written once for every truncated series: for points with partials to order 2, and for mixed partials
/// of higher order.
struct SurfaceFormula {
  template <class Generic>
  // Implicit on purpose: a row of the table names its formula.
  constexpr SurfaceFormula(Generic generic) : taylor2(generic), mixed(generic) {}

  Taylor2Point (*taylor2)(const double* measures, const Taylor2& u, const Taylor2& v);
  PointOf<MixedSeries> (*mixed)(const double* measures, const MixedSeries& u, const MixedSeries& v);
};

/// A model surface S(u,v): one row of the table that page, panel, documents and tests iterate.
struct CatalogueSurfaceRow {
  std::string_view id;     ///< in documents, as `bohemian-dome`
  std::string_view label;  ///< for readers, as `Dini's surface`
  std::string_view name;   ///< in a sentence after "the", as `Dini surface`
  std::span<const CatalogueMeasure> measures;
  CatalogueDirection u, v;
  /// The only place where the surface is written down.
  SurfaceFormula formula;
  /// False where pieces meet at an angle: in the classic Klein bottle S_u jumps in the middle of the u-domain, where
  /// the partials are those on its left, and at the seam, where they are those within the domain.
  bool smooth = true;
  CatalogueCheck check = nullptr;
};

/// The 28 surfaces of oracle 09 (its two halves of the Klein bottle are one), each with its formula in the source.
/// Source: THEORY 3.
std::span<const CatalogueSurfaceRow> surface_catalogue();
/// nullptr when there is no such id.
const CatalogueSurfaceRow* find_catalogue_surface(std::string_view id);

/// A surface of the catalogue. A plain value: whoever sets its members himself calls validate() before anything else.
struct CatalogueSurface {
  int row = 0;  ///< in surface_catalogue()
  CatalogueMeasures measures{};

  bool operator==(const CatalogueSurface&) const = default;
};

/// One value for each of the row's measures, or none for the standard picture. Error path: `id`, `measures` (their
/// number) or the id of the measure that is wrong.
Result<CatalogueSurface> make_catalogue_surface(std::string_view id, std::span<const double> measures = {});

/// Plane origin + u u_axis + v v_axis, cylinder and torus of the catalogue, without a check of the measures.
CatalogueSurface plane_surface(const Eigen::Vector3d& origin = {-1, -1, 0}, const Eigen::Vector3d& u_axis = {2, 0, 0},
                               const Eigen::Vector3d& v_axis = {0, 2, 0});
CatalogueSurface cylinder_surface(double radius_x = 1, double radius_y = 1, double height = 2);
CatalogueSurface torus_surface(double wheel_radius = 1, double tube_radius = 0.4, double tube_height = 0.4);

/// As make_catalogue_surface(); moreover `row` when there is no such row, and `measures` when one behind the row's last
/// is not 0.
Status validate(const CatalogueSurface& surface);

SurfaceDomain domain(const CatalogueSurface& surface);

/// Point and partials from one formula on truncated Taylor series. u, v are finite and not reduced to the domain, over
/// which closed directions go round; only the v of the apple, of Dini's and of Kuen's surface, whose logarithms end
/// near it, is held in it. Error of each partial below 1e-12 of its largest on the domain.
SurfaceJet evaluate(const CatalogueSurface& surface, double u, double v);

/// The same formula on a higher series, as mixed_partials() needs it.
PointOf<MixedSeries> series_of(const CatalogueSurface& surface, const MixedSeries& u, const MixedSeries& v);

/// All pairs: out[a * v.size() + b] belongs to (u[a], v[b]). Allocates nothing.
void evaluate_grid(const CatalogueSurface& surface, std::span<const double> u, std::span<const double> v,
                   std::span<SurfaceJet> out);

}  // namespace knotwork
