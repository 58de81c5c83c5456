#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace knotwork {

/// A net of points stored row by row, columns in a row, with its two directions exchanged.
inline std::vector<Eigen::Vector3d> transposed(std::span<const Eigen::Vector3d> net, int columns) {
  const std::size_t width = static_cast<std::size_t>(columns), rows = net.size() / width;
  std::vector<Eigen::Vector3d> out;
  out.reserve(net.size());
  for (std::size_t j = 0; j < width; ++j) {
    for (std::size_t i = 0; i < rows; ++i) out.push_back(net[i * width + j]);
  }
  return out;
}

/// The net of the rows change(row), all of one new length. `change` takes and returns a std::vector of points.
template <class Change>
std::vector<Eigen::Vector3d> changed_rows(std::span<const Eigen::Vector3d> net, int columns, const Change& change) {
  const std::size_t width = static_cast<std::size_t>(columns);
  std::vector<Eigen::Vector3d> out;
  for (std::size_t first = 0; first < net.size(); first += width) {
    const std::span<const Eigen::Vector3d> row = net.subspan(first, width);
    const std::vector<Eigen::Vector3d> changed = change(std::vector<Eigen::Vector3d>(row.begin(), row.end()));
    out.insert(out.end(), changed.begin(), changed.end());
  }
  return out;
}

/// The same for the columns; `columns` of the given net.
template <class Change>
std::vector<Eigen::Vector3d> changed_columns(std::span<const Eigen::Vector3d> net, int columns, const Change& change) {
  const int rows = static_cast<int>(net.size()) / columns;
  const std::vector<Eigen::Vector3d> changed = changed_rows(transposed(net, columns), rows, change);
  return transposed(changed, static_cast<int>(changed.size()) / columns);
}

}  // namespace knotwork
