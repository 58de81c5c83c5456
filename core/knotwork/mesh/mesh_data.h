#pragma once

#include <cstdint>
#include <vector>

namespace knotwork {

/// A triangle mesh ready for the GPU or a file: float32, model units, counter-clockwise seen from the normal's side.
struct MeshData {
  std::vector<float> positions;        ///< x y z a vertex
  std::vector<float> normals;          ///< unit, x y z a vertex
  std::vector<float> parameters;       ///< u v a vertex
  std::vector<std::uint32_t> indices;  ///< three a triangle

  std::size_t vertex_count() const { return positions.size() / 3; }
  std::size_t triangle_count() const { return indices.size() / 3; }
};

}  // namespace knotwork
