#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include <Eigen/Geometry>

#include "knotwork/basis/point_columns.h"
#include "knotwork/surface/surface_frame.h"

namespace knotwork {

/// So many points of a grid's row are computed at a time.
inline constexpr std::size_t row_piece = 64;

/// Frames of neighbouring points of a row, number by number, in the order of SurfaceFrame.
class FrameColumns {
  static constexpr std::size_t columns = 12;
  static constexpr double least_square = 1e-280, most_square = 1e280, least_sine = 1e-12;

  /// From |S_u x S_v|^2 and |S_u|^2 |S_v|^2, which may be Lanes.
  static auto is_regular(const auto& square, const auto& squares) {
    return (square > least_sine * least_sine * squares) & (square > least_square) & (square < most_square);
  }

 public:
  static constexpr std::size_t s = 0, su = 3, sv = 6, normal = 9;  // the columns of their x

  double* at(std::size_t column, std::size_t m) { return columns_.at(column, m); }

  /// The frames with their unit normals, S_u x S_v / |S_u x S_v|. Where that vanishes or overflows, the normal is
  /// degenerate(k), k the frame's place in `out`. Precondition: 1 <= out.size() <= row_piece.
  template <class Degenerate>
  void hand_over(std::span<SurfaceFrame> out, const Degenerate& degenerate) {
    static_assert(sizeof(SurfaceFrame) == columns * sizeof(double));
    // Places without a point compute something harmless.
    for (std::size_t c = 0; c < 3; ++c) {
      std::fill(at(su + c, out.size()), at(su + c, row_piece), c == 0 ? 1.0 : 0.0);
      std::fill(at(sv + c, out.size()), at(sv + c, row_piece), c == 1 ? 1.0 : 0.0);
    }
    const bool regular = set_normals();
    columns_.hand_over(out.size(), out.front().s.data());
    if (regular) return;
    for (std::size_t m = 0; m < out.size(); ++m) {
      const SurfaceFrame& frame = out[m];
      const double square = frame.su.cross(frame.sv).squaredNorm();
      if (!is_regular(square, frame.su.squaredNorm() * frame.sv.squaredNorm())) out[m].normal = degenerate(m);
    }
  }

 private:
  /// True when all of them are good.
  bool set_normals() {
    decltype(Lanes{} < Lanes{}) regular = Lanes{} == Lanes{};
    for (std::size_t m = 0; m < row_piece; m += lane_count) {
      Lanes ux, uy, uz, vx, vy, vz;
      load(ux, at(su, m));
      load(uy, at(su + 1, m));
      load(uz, at(su + 2, m));
      load(vx, at(sv, m));
      load(vy, at(sv + 1, m));
      load(vz, at(sv + 2, m));
      const Lanes x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
      const Lanes square = x * x + y * y + z * z;
      regular &= is_regular(square, (ux * ux + uy * uy + uz * uz) * (vx * vx + vy * vy + vz * vz));
      const Lanes inverse = 1 / square_root(square > least_square ? square : Lanes{} + least_square);
      store(x * inverse, at(normal, m));
      store(y * inverse, at(normal + 1, m));
      store(z * inverse, at(normal + 2, m));
    }
    for (std::size_t k = 0; k < lane_count; ++k) {
      if (regular[k] == 0) return false;
    }
    return true;
  }

  PointColumns<columns, row_piece> columns_;
};

}  // namespace knotwork
