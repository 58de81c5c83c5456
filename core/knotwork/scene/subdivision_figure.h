#pragma once

#include <vector>

#include <Eigen/Core>

#include "knotwork/scene/curve_figure.h"
#include "knotwork/scene/objects.h"

namespace knotwork::scene {

/// What stands on the stage of a subdivision: everything that is drawn of it, held or read off.
struct SubdivisionFigure {
  /// How far the polygon of a level is from the limit: max_j |q_j - c(t_j)| at the vertices' own parameters, those
  /// outside the domain of an open limit left out.
  struct LevelDistance {
    int level;
    double maximum;  ///< model units
  };

  /// Precondition: the object is valid.
  explicit SubdivisionFigure(const SubdivisionCurveObject& object);

  int level;  ///< whole levels done
  int pass;   ///< steps done of the next: 0 none, 1 the split, 2.. averaging passes
  bool closed;
  bool limit_shown;
  std::vector<Eigen::Vector3d> points;  ///< of the polygon at the start
  /// The polygon now. In an averaging pass its vertices are on their way, by the fraction, from p_i to the midpoint of
  /// p_i and p_{i+1}.
  std::vector<Eigen::Vector3d> polygon;
  /// Whether the vertices come in pairs, as the split has left them.
  bool doubled;
  CurveFigure limit;
  /// From level 0 on, up to the walk's last, and further while it costs little.
  std::vector<LevelDistance> distances;
};

}  // namespace knotwork::scene
