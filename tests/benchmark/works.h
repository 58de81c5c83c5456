#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "benchmark/kernel.h"
#include "knotwork/curve/bspline_curve.h"
#include "knotwork/surface/blending_surface.h"
#include "knotwork/surface/bspline_surface.h"

// The works in which Knotwork is measured beside its rivals: the same input for all, one way to run and one to check. A
// kernel is called "work | contender"; works.json has the works' targets.

namespace knotwork::benchmark {

/// W1: a million parameters of a cubic curve, call by call into one buffer that stays in the second-level cache.
struct CurveWork {
  const char* name;
  int points;
  int order;  ///< of the derivatives: 0 or 2
  bool sorted;

  BSplineCurve curve() const;
};
inline constexpr std::size_t curve_parameters = 1000000, parameters_of_a_call = 4096;
std::span<const CurveWork> curve_works();

/// out: order + 1 vectors for each parameter.
using EvaluateCurve = std::function<void(std::span<const double> t, Eigen::Vector3d* out)>;
Kernel curve_contender(const CurveWork& work, const std::string& contender, const EvaluateCurve& evaluate);

/// W2 and W4: a grid of frames, S, S_u, S_v and the unit normal, or of points alone.
struct GridWork {
  std::string name;
  std::size_t side;
  bool frames;
  std::vector<double> u, v;
};
/// A bicubic surface of 32 x 32 points.
BSplineSurface surface_work();
GridWork surface_grid(bool frames);
/// A torus of n x n patches, all moved.
BlendingSurface blending_work(int patches);
GridWork blending_grid(int patches);

/// Columns: S, and for frames S_u, S_v and the normal.
using Frame = Eigen::Matrix<double, 3, 4>;
/// run() fills the contender's own buffer; at(k) reads grid point k from it, a * side + b at (u[a], v[b]).
/// `normals` is false where the rival has partials but no normals.
Kernel surface_contender(const GridWork& work, const std::string& contender, std::function<void()> run,
                         const std::function<Frame(std::size_t)>& at, bool normals = true);
Kernel blending_contender(const GridWork& work, int patches, const std::string& contender, std::function<void()> run,
                          const std::function<Frame(std::size_t)>& at);

/// Knotwork's rows and the core's readable references.
std::vector<Kernel> work_kernels();
/// The libraries that were found where this was built.
std::vector<Kernel> rival_kernels();

}  // namespace knotwork::benchmark
