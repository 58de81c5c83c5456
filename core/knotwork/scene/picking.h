#pragma once

#include <optional>

#include "knotwork/surface/blending_surface.h"

namespace knotwork::scene {

struct Ray {
  Eigen::Vector3d origin, direction;  ///< direction of any length
};

struct SurfaceHit {
  double u, v;
  double distance;  ///< along the unit direction, model units
  SurfaceJet jet;
};

/// A coarse net of a surface that rays are tried against, 12 steps a knot interval up to about 200 x 200. Rebuilt when
/// the surface moves.
class PickNet {
 public:
  explicit PickNet(const BlendingSurface& surface);
  /// The nearest point of the surface on the ray (from the net, polished by Newton's method on the true surface to
  /// 1e-10 of its size), if the ray meets it in front of its origin.
  std::optional<SurfaceHit> pick(const BlendingSurface& surface, const Ray& ray) const;

  Eigen::Vector3d centre() const { return centre_; }
  double radius() const { return radius_; }  ///< of a ball round centre() that holds the net

 private:
  int columns_ = 0, rows_ = 0;
  std::vector<double> u_, v_;
  std::vector<Eigen::Vector3d> points_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  double radius_ = 0;
};

}  // namespace knotwork::scene
