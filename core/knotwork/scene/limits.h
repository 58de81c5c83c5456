#pragma once

namespace knotwork::scene {

/// The closed interval that a number of a document lies in. Stated once: the parameter table, the checks of commands
/// and documents and (held to it by a test) the JSON Schema have their limits from here.
struct Limits {
  double min, max;
  /// False for NaN, which is asked about first: an ordered comparison with it would raise the invalid-operation flag.
  constexpr bool contains(double x) const { return x == x && min <= x && x <= max; }
};

inline constexpr int min_locals = 2, max_locals = 128;     ///< local surfaces in one direction
inline constexpr int min_samples = 8, max_samples = 1024;  ///< steps in one direction
inline constexpr double max_coordinate = 1e6;              ///< model units, any coordinate or length
inline constexpr double min_length = 1e-3;                 ///< model units, radii, heights and the camera's distance
inline constexpr int max_points = 512;                     ///< control points of a curve on the stage
inline constexpr int max_degree = 9;                       ///< of a B-spline curve on the stage
inline constexpr double clock_period = 6.283185307179586;  ///< every motion repeats after 2 pi

namespace limits {
inline constexpr Limits locals{min_locals, max_locals};
inline constexpr Limits local_index{0, max_locals - 1};
inline constexpr Limits samples{min_samples, max_samples};
inline constexpr Limits coordinate{-max_coordinate, max_coordinate};
inline constexpr Limits length{min_length, max_coordinate};
inline constexpr Limits scale{0.01, 100};
inline constexpr Limits quaternion{-1.000001, 1.000001};  ///< a component of a unit quaternion, with room for rounding
inline constexpr Limits blending_parameter{0, 64};        ///< each family has narrower ones of its own
inline constexpr Limits azimuth{-1e4, 1e4};               ///< radians; many turns are no error
inline constexpr Limits elevation{-1.57, 1.57};           ///< radians; just short of the poles
inline constexpr Limits time{0, clock_period};            ///< seconds of the clock
inline constexpr Limits elapsed{0, 1e9};                  ///< seconds of real time that the clock is advanced by
inline constexpr Limits speed{0.1, 4};                    ///< seconds of the clock a second
inline constexpr Limits amplitude{0, 3};                  ///< model units (a second, for the report's motion)
inline constexpr Limits share{0, 1};
inline constexpr Limits degree{1, max_degree};
inline constexpr Limits bezier_points{2, 17};  ///< degree 16 at most
inline constexpr Limits points{2, max_points};
inline constexpr Limits knots{4, max_points + 2 * max_degree + 1};
inline constexpr Limits objects{1, 16};  ///< how many in a document
inline constexpr Limits patches{0, max_locals* max_locals};
inline constexpr Limits id_length{1, 64}, label_length{0, 200};  ///< characters
}  // namespace limits

}  // namespace knotwork::scene
