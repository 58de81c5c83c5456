#pragma once

#include <span>
#include <string_view>

#include <Eigen/Core>

#include "knotwork/basis/interval.h"
#include "knotwork/basis/knot_vector.h"
#include "knotwork/catalogue_measure.h"
#include "knotwork/curve/taylor3.h"

namespace knotwork {

/// A model curve c(t): one row of the table that page, panel, documents and tests iterate.
struct CatalogueCurveRow {
  std::string_view id;     ///< in documents, as `torus-knot`
  std::string_view label;  ///< for readers
  std::span<const CatalogueMeasure> measures;
  /// Closed: c(t + end - start) = c(t) with all derivatives, whatever the measures. Open: the ends differ.
  Topology topology;
  Interval (*domain)(const double* measures);
  /// The only place where the curve is written down; entire in t.
  Taylor3Point (*formula)(const double* measures, const Taylor3& t);
  CatalogueCheck check = nullptr;
};

/// The 17 curves of oracle 09 (its two roses are one), each with its formula in the source. Source: THEORY 3.
std::span<const CatalogueCurveRow> curve_catalogue();
/// nullptr when there is no such id.
const CatalogueCurveRow* find_catalogue_curve(std::string_view id);

/// A curve of the catalogue. A plain value: whoever sets its members himself calls validate() before anything else.
struct CatalogueCurve {
  int row = 0;  ///< in curve_catalogue()
  CatalogueMeasures measures{};

  bool operator==(const CatalogueCurve&) const = default;
};

/// One value for each of the row's measures, or none for the standard picture. Error path: `id`, `measures` (their
/// number) or the id of the measure that is wrong.
Result<CatalogueCurve> make_catalogue_curve(std::string_view id, std::span<const double> measures = {});

/// As make_catalogue_curve(); moreover `row` when there is no such row, and `measures` when one behind the row's last
/// is not 0.
Status validate(const CatalogueCurve& curve);

Interval domain(const CatalogueCurve& curve);

/// out[k] = the k-th derivative with respect to t, k = 0 .. out.size()-1, at most the third. t is finite and is not
/// reduced to the domain: closed curves go round, open ones go on. Error below 1e-12 of the largest |D^k c| on the
/// domain.
void evaluate(const CatalogueCurve& curve, double t, std::span<Eigen::Vector3d> out);
/// The same for many parameters: out[m (order+1) + k] at t[m]. Allocates nothing.
void evaluate(const CatalogueCurve& curve, std::span<const double> t, int order, std::span<Eigen::Vector3d> out);

}  // namespace knotwork
