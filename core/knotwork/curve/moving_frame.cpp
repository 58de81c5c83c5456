#include "knotwork/curve/moving_frame.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include <Eigen/Geometry>

#include "knotwork/curve/curve_measures.h"
#include "knotwork/curve/vector_length.h"

namespace knotwork {
namespace {

/// A shorter difference of unit vectors is rounding, and has no direction.
constexpr double least_difference = 1e-10;

/// x mirrored in the plane through 0 across `axis`; x itself when there is no axis.
Eigen::Vector3d mirrored(const Eigen::Vector3d& x, const Eigen::Vector3d& axis) {
  const double square = axis.squaredNorm();
  return square > least_difference * least_difference ? Eigen::Vector3d(x - (2 * axis.dot(x) / square) * axis) : x;
}

Eigen::Vector3d turned(const Eigen::Vector3d& x, const Eigen::Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis) * x;
}

/// A frame on its way along a curve.
class FrameCarrier {
 public:
  FrameCarrier(const CurveView& curve, int steps) : curve_(curve), steps_(steps) {}

  void start(double t, const Eigen::Vector3d& wish) {
    at(t);
    frame_.point = point_;
    frame_.tangent = tangent_;
    set_normal(unit_across(tangent_, wish));
  }
  const MovingFrame& frame() const { return frame_; }
  double way() const { return way_; }

  /// From the parameter `from`, where the frame is, to `to`.
  void carry(double from, double to) {
    if (!(from < to)) return;
    const std::vector<double> ends = piece_ends(from, to, curve_.breaks);
    for (std::size_t piece = 1; piece < ends.size(); ++piece) {
      for (int k = 1; k < steps_; ++k) {
        at(std::lerp(ends[piece - 1], ends[piece], static_cast<double>(k) / steps_));
        step();
      }
      at(just_before(ends[piece]));
      step();
      // On from the tangent in front of a break to the one behind it.
      if (ends[piece] < curve_.end) corner(ends[piece]);
    }
  }

  /// To the tangent at t, where the frame's point already is.
  void corner(double t) {
    at(t);
    // The first mirror lies across the tangent, for want of a chord.
    turn(frame_.tangent);
  }

 private:
  void at(double t) {
    std::array<Eigen::Vector3d, 4> c;
    curve_.evaluate(t, c);
    point_ = c[0];
    tangent_ = unit_tangent(c);
  }

  void step() {
    const Eigen::Vector3d chord = point_ - frame_.point;
    const double length = vector_length(chord);
    way_ += length;
    turn(length > 0 ? Eigen::Vector3d(chord / length) : frame_.tangent);
  }

  void turn(const Eigen::Vector3d& chord) {
    const Eigen::Vector3d tangent = mirrored(frame_.tangent, chord);
    const Eigen::Vector3d normal = mirrored(mirrored(frame_.normal, chord), tangent_ - tangent);
    frame_.point = point_;
    frame_.tangent = tangent_;
    // Only rounding is taken off: the normal is across already.
    set_normal(unit_across(tangent_, normal));
  }

  void set_normal(const Eigen::Vector3d& normal) {
    frame_.normal = normal;
    frame_.binormal = frame_.tangent.cross(normal);
  }

  CurveView curve_;
  int steps_;
  MovingFrame frame_;
  double way_ = 0;
  Eigen::Vector3d point_, tangent_;  ///< of the curve, where the frame goes next
};

Status check_parameters(const CurveView& curve, std::span<const double> t) {
  for (std::size_t i = 0; i < t.size(); ++i) {
    const bool inside = std::isfinite(t[i]) && t[i] >= curve.start && t[i] <= curve.end;
    if (!inside || (i > 0 && t[i] <= t[i - 1]))
      return Error{"t[" + std::to_string(i) + "]", "The parameters must grow within the curve's domain."};
  }
  if (curve.closed() && !t.empty() && t.front() == curve.start && t.back() == curve.end && t.size() > 1)
    return Error{"t", "On a closed curve the last parameter must lie less than a period behind the first."};
  return success();
}

}  // namespace

double turn_about(const Eigen::Vector3d& axis, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return std::atan2(axis.dot(from.cross(to)), from.dot(to));
}

Result<MovingFrames> rotation_minimising_frames(const CurveView& curve, std::span<const double> t,
                                                const MovingFrameOptions& options) {
  if (Status status = check_parameters(curve, t); !status) return status.error();
  if (options.steps < 1) return Error{"steps", "There must be at least one step."};
  for (const double coordinate : options.first_normal) {
    if (!std::isfinite(coordinate)) return Error{"firstNormal", "The first normal must have finite coordinates."};
  }
  MovingFrames result;
  if (t.empty()) return result;

  FrameCarrier carrier(curve, options.steps);
  std::vector<double> ways;
  carrier.start(t.front(), options.first_normal);
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (i > 0) carrier.carry(t[i - 1], t[i]);
    result.frames.push_back(carrier.frame());
    ways.push_back(carrier.way());
  }
  if (!curve.closed()) return result;

  carrier.carry(t.back(), curve.end);
  carrier.corner(curve.start);
  carrier.carry(curve.start, t.front());
  const MovingFrame& first = result.frames.front();
  result.mismatch = turn_about(first.tangent, first.normal, carrier.frame().normal);
  if (options.spread_mismatch && carrier.way() > 0) {
    for (std::size_t i = 0; i < ways.size(); ++i) {
      MovingFrame& frame = result.frames[i];
      frame.normal = turned(frame.normal, frame.tangent, -result.mismatch * (ways[i] / carrier.way()));
      frame.binormal = frame.tangent.cross(frame.normal);
    }
  }
  return result;
}

}  // namespace knotwork
