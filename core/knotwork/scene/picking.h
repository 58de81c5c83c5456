#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "knotwork/surface/knotted_surface.h"

namespace knotwork::scene {

struct Ray {
  Eigen::Vector3d origin, direction;  ///< direction of any length but 0
};

struct SurfaceHit {
  double u, v;      ///< in the domain
  double distance;  ///< along the unit direction, model units
  SurfaceJet jet;
};

/// A coarse net of a surface that rays are tried against, 12 steps a knot interval up to about 200 x 200. Rebuilt when
/// the surface moves.
class PickNet {
 public:
  explicit PickNet(const KnottedSurface& surface);
  /// The nearest point of the surface on the ray (from the net, polished by Newton's method on the true surface to
  /// 1e-10 of its size), if the ray meets it in front of its origin. Both sides of the surface count. What bulges out
  /// of the net by less than its sagitta can be missed where the ray only grazes it.
  std::optional<SurfaceHit> pick(const KnottedSurface& surface, const Ray& ray) const;

  Eigen::Vector3d centre() const { return centre_; }
  double radius() const { return radius_; }  ///< of a ball round centre() that holds the net

 private:
  /// A ball round a block of the net's cells, so that a ray is tried against few triangles.
  struct Block {
    int first_column, last_column, first_row, last_row;  ///< vertices, last included
    Eigen::Vector3d centre;
    double radius;
  };

  const Eigen::Vector3d& point(int column, int row) const {
    return points_[static_cast<std::size_t>(column) * v_.size() + static_cast<std::size_t>(row)];
  }

  std::vector<double> u_, v_;  ///< a closed direction ends with its end, where the points of its start are again
  std::vector<Eigen::Vector3d> points_;
  std::vector<Block> blocks_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  double radius_ = 0;
};

}  // namespace knotwork::scene
