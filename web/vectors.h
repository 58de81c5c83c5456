#pragma once

#include <Eigen/Core>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "knotwork/scene/palette.h"

namespace knotwork::web {

// The core speaks Eigen and arrays, the front end GLM; this is where they meet.

inline glm::dvec3 to_glm(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline glm::vec3 to_glm(const scene::Colour& c) { return {c[0], c[1], c[2]}; }
inline glm::vec4 to_glm(const scene::Colour& c, float alpha) { return {c[0], c[1], c[2], alpha}; }
inline Eigen::Vector3d to_eigen(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

inline glm::dmat3 to_glm_matrix(const Eigen::Matrix3d& m) {
  return {to_glm(Eigen::Vector3d(m.col(0))), to_glm(Eigen::Vector3d(m.col(1))), to_glm(Eigen::Vector3d(m.col(2)))};
}

}  // namespace knotwork::web
