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
inline constexpr int max_curve_locals = 64;                ///< of a blending curve
inline constexpr int max_degree = 9;                       ///< of a B-spline curve or surface on the stage
inline constexpr int max_net = 64;                         ///< control points of a surface in one direction
inline constexpr int max_data_points = 20000;              ///< of a fitted curve
inline constexpr int max_document_points = 32768;          ///< of all curves of a document together
inline constexpr int max_vertices = 1 << 16;               ///< of a subdivided polygon on the stage
inline constexpr double clock_period = 6.283185307179586;  ///< every motion repeats after 2 pi

namespace limits {
inline constexpr Limits locals{min_locals, max_locals};
inline constexpr Limits local_index{0, max_locals - 1};
inline constexpr Limits samples{min_samples, max_samples};
inline constexpr Limits coordinate{-max_coordinate, max_coordinate};
inline constexpr Limits length{min_length, max_coordinate};
inline constexpr Limits patch_degree{1, 3};  ///< of Bezier-Hermite patches
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
inline constexpr Limits data_points{2, max_data_points};
inline constexpr Limits smoothing{0, 1e6};
inline constexpr Limits levels{0, 15};  ///< 2 points have max_vertices after so many
inline constexpr Limits steps{0, 15 * (max_degree + 1)};
inline constexpr Limits knots{4, max_points + 2 * max_degree + 1};
inline constexpr Limits curve_locals{min_locals, max_curve_locals};
inline constexpr Limits local_degree{1, 3};  ///< of Bezier-Hermite locals: the catalogue gives three derivatives
inline constexpr Limits inner_knots{0, max_curve_locals - 1};
inline constexpr Limits net{2, max_net};  ///< rows, and points in a row
inline constexpr Limits net_knots{4, max_net + 2 * max_degree + 1};
inline constexpr Limits rings{0, 8};
inline constexpr Limits objects{1, 16};  ///< how many in a document
inline constexpr Limits patches{0, max_locals* max_locals};
inline constexpr Limits id_length{1, 64}, label_length{0, 200};  ///< characters
}  // namespace limits

}  // namespace knotwork::scene
