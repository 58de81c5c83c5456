#pragma once

namespace knotwork {

/// The parameters from `start` to `end`, start < end.
struct Interval {
  double start, end;
};

}  // namespace knotwork
