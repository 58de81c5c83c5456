#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "knotwork/curve/least_squares.h"
#include "knotwork/curve/parameterization.h"
#include "knotwork/result.h"

namespace knotwork {

/// Where the knots of a fit stand.
enum class KnotPlacement : unsigned char {
  even,     ///< equidistant; clamped when open
  averaged  ///< among the parameters, as averaged_knots() places them
};

/// A fit asked for by the number of its control points.
struct CurveFitSettings {
  int degree = 3;
  int count = 8;  ///< n, control points
  Topology topology = Topology::open;
  double exponent = uniform_exponent;  ///< of the chord length in the parameters, as in parameterize()
  KnotPlacement knots = KnotPlacement::even;
  bool interpolate_ends = false;  ///< open curves only
  double smoothing = 0;           ///< lambda >= 0 of LeastSquaresOptions
};

struct CurveFit {
  LeastSquaresFit fit;
  std::vector<double> parameters;  ///< x_j, in the domain of fit.curve
};

/// The least-squares curve through or near points p_0 .. p_{m-1}, model units, that it passes in this order: parameters
/// by parameterize(), knots even or averaged, control points by fit_least_squares(). The domain is [0, n-p] open and
/// [0, n) closed.
///
/// Errors, with paths: `degree`, `count` (of knots), `points` (fewer than 2, fewer than free control points, all in one
/// place), `points[i]`, `exponent`, `parameters` (they leave basis functions without data; the message names these),
/// `knots` (so many neighbouring points coincide that averaged ones do, too), `smoothing`, `interpolate_ends`.
/// Sources: THEORY 2.4 and those of the three.
Result<CurveFit> fit_curve(std::span<const Eigen::Vector3d> points, const CurveFitSettings& settings);

/// How near n control points come to the data.
struct CurveFitError {
  int count;            ///< n
  double rms, maximum;  ///< as in LeastSquaresFit
};

/// fit_curve() for every n from the least that degree and topology allow to `most`; an n that is refused is left out.
std::vector<CurveFitError> fit_errors(std::span<const Eigen::Vector3d> points, CurveFitSettings settings, int most);

/// The fewest control points of a curve: p+1 open, max(2, p) closed.
int least_control_points(int degree, Topology topology);

}  // namespace knotwork
