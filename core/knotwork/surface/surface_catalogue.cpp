#include "knotwork/surface/surface_catalogue.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <type_traits>

#include <Eigen/Geometry>

#include "knotwork/basis/integer_power.h"
#include "knotwork/surface/mixed_series.h"

namespace knotwork {
namespace {

using std::numbers::pi;
constexpr double third_of_turn = 2 * pi / 3;

constexpr CatalogueDirection open_on(double start, double end) { return {{start, end}}; }
constexpr CatalogueDirection closed_on(double start, double end) { return {{start, end}, Closure::closed}; }
constexpr CatalogueDirection twisted_on(double start, double end, double reflection) {
  return {{start, end}, Closure::twisted, reflection};
}
constexpr CatalogueDirection between_poles(double start, double end) {
  return {{start, end}, Closure::open, 0, true, true};
}
constexpr CatalogueDirection turn = closed_on(0, 2 * pi), turn_about_zero = closed_on(-pi, pi);

constexpr CatalogueDirection disc_u{{0, 1}, Closure::open, 0, true, false, 0};   // times the radius
constexpr CatalogueDirection cone_u{{-1, 1}, Closure::open, 0, false, true, 1};  // times the height
constexpr CatalogueDirection eight_v{{0, 2 * pi}, Closure::closed, 0, true, true};

template <class Series>
PointOf<Series> point_of(const Series& x, const Series& y, const Series& z) {
  return {x, y, z};
}

/// At that angle about the z-axis, `radius` away from it.
template <class Series>
PointOf<Series> about_z(const Series& radius, const Series& angle, const std::type_identity_t<Series>& z) {
  return {radius * cos(angle), radius * sin(angle), z};
}

template <class Series>
PointOf<Series> scaled(double size, const PointOf<Series>& p) {
  return {size * p.x, size * p.y, size * p.z};
}
template <class Series>
PointOf<Series> scaled(double size, const Series& x, const Series& y, const Series& z) {
  return {size * x, size * y, size * z};
}

double value_of(const Taylor2& w) { return w.value; }
double value_of(const MixedSeries& w) { return w.value(); }

/// ln tan(v/2), 0 < v < pi, whose derivative is 1 / sin v.
Taylor2 log_tan_half(const Taylor2& v) {
  const double r = 1 / std::sin(v.value);
  return compose(v, std::log(std::tan(v.value / 2)), r, -std::cos(v.value) * r * r);
}
MixedSeries log_tan_half(const MixedSeries& v) { return log(sin(0.5 * v) / cos(0.5 * v)); }

/// The parameter itself inside the interval; its nearer end, with the partials there, outside.
Taylor2 held(Taylor2 w, const Interval& interval) {
  w.value = std::clamp(w.value, interval.start, interval.end);
  return w;
}
MixedSeries held(MixedSeries w, const Interval& interval) {
  w.coefficient(0, 0) = std::clamp(w.value(), interval.start, interval.end);
  return w;
}
constexpr Interval apple_v{-pi, pi}, dini_v{0.001, 2}, kuen_v{0.05, pi - 0.05};

template <class Series>
PointOf<Series> klein_bottle(const double* m, const Series& any_u, const Series& any_v) {
  // The two pieces are given on [0, 2pi]: other turns are brought there, every second one reflected.
  Series u = any_u, v = any_v;
  if (value_of(u) < 0 || value_of(u) > 2 * pi) {
    const double turns = std::floor(value_of(u) / (2 * pi));
    u = u - 2 * pi * turns;
    if (std::fmod(turns, 2) != 0) v = pi - v;
  }
  const Series tube = m[2] * (1 - 0.5 * cos(u)), across = tube * cos(v);
  const Series x = m[0] * cos(u) * (1 + sin(u)), y = m[1] * sin(u), z = tube * sin(v);
  if (value_of(u) <= pi) return {x + across * cos(u), y + across * sin(u), z};
  return {x - across, y, z};
}

template <class Series>
Series slippers_coordinate(const Series& u, const Series& v, int a, int b) {
  return (2 + cos(u)) * integer_power(cos(v), a) * integer_power(sin(v), b);
}

Status check_plane(const double* m) {
  const Eigen::Vector3d u_axis{m[3], m[4], m[5]}, v_axis{m[6], m[7], m[8]};
  const double length_u = u_axis.norm(), length_v = v_axis.norm();
  if (length_u < shortest_length) return Error{"uAxisX", "The first axis of the plane must not be zero."};
  if (length_v < shortest_length || u_axis.cross(v_axis).norm() < 1e-9 * length_u * length_v) {
    return Error{"vAxisX", "The second axis of the plane must be neither zero nor parallel to the first."};
  }
  return success();
}

constexpr CatalogueMeasure plane_measures[] = {
    coordinate_measure("originX", "Origin x", -1),    coordinate_measure("originY", "Origin y", -1),
    coordinate_measure("originZ", "Origin z", 0),     coordinate_measure("uAxisX", "First axis x", 2),
    coordinate_measure("uAxisY", "First axis y", 0),  coordinate_measure("uAxisZ", "First axis z", 0),
    coordinate_measure("vAxisX", "Second axis x", 0), coordinate_measure("vAxisY", "Second axis y", 2),
    coordinate_measure("vAxisZ", "Second axis z", 0)};
constexpr CatalogueMeasure disc_measures[] = {length_measure("radius", "Radius", 1.2)};
constexpr CatalogueMeasure cylinder_measures[] = {length_measure("radiusX", "Radius in x", 1),
                                                  length_measure("radiusY", "Radius in y", 1),
                                                  length_measure("height", "Height", 2)};
constexpr CatalogueMeasure cone_measures[] = {length_measure("radius", "Radius in the middle", 0.6),
                                              length_measure("height", "Half height", 1)};
constexpr CatalogueMeasure sphere_measures[] = {length_measure("radius", "Radius", 1.2)};
constexpr CatalogueMeasure torus_measures[] = {length_measure("wheelRadius", "Wheel radius", 1),
                                               length_measure("tubeRadius", "Tube radius", 0.4),
                                               length_measure("tubeHeight", "Tube height", 0.4)};
constexpr CatalogueMeasure asteroidal_sphere_measures[] = {
    length_measure("radiusX", "Cube root of the radius in x", 1.15),
    length_measure("radiusY", "Cube root of the radius in y", 1.15),
    length_measure("radiusZ", "Cube root of the radius in z", 1.15)};
constexpr CatalogueMeasure apple_measures[] = {length_measure("size", "Size", 0.18)};
constexpr CatalogueMeasure second_apple_measures[] = {length_measure("size", "Size", 0.5)};
constexpr CatalogueMeasure seashell_measures[] = {length_measure("size", "Size", 0.2)};
constexpr CatalogueMeasure bent_horns_measures[] = {length_measure("size", "Size", 0.25)};
constexpr CatalogueMeasure bohemian_dome_measures[] = {length_measure("radius", "Radius of the moved circle", 1),
                                                       length_measure("width", "Width of its way", 0.5),
                                                       length_measure("height", "Height of its way", 0.5)};
constexpr CatalogueMeasure size_measures[] = {length_measure("size", "Size", 1)};
constexpr CatalogueMeasure larger_size_measures[] = {length_measure("size", "Size", 1.5)};
constexpr CatalogueMeasure moebius_measures[] = {length_measure("radius", "Radius", 1),
                                                 length_measure("width", "Half width", 0.4)};
constexpr CatalogueMeasure klein_bottle_measures[] = {length_measure("width", "Width of the loop", 0.6),
                                                      length_measure("height", "Height of the loop", 1.6),
                                                      length_measure("tubeRadius", "Tube radius", 0.4)};
constexpr CatalogueMeasure figure_eight_klein_bottle_measures[] = {length_measure("radius", "Wheel radius", 2.5),
                                                                   length_measure("size", "Size of the tube", 0.4)};
constexpr CatalogueMeasure cross_cap_measures[] = {length_measure("radius", "Radius of the mapped sphere", 1.2)};
constexpr CatalogueMeasure steiner_measures[] = {length_measure("radius", "Radius of the mapped sphere", 1.7)};
constexpr CatalogueMeasure dini_measures[] = {length_measure("radius", "Radius", 0.5),
                                              length_measure("rise", "Rise per radian", 0.2)};
constexpr CatalogueMeasure kuen_measures[] = {length_measure("radius", "Radius", 0.7)};
constexpr CatalogueMeasure enneper_measures[] = {length_measure("size", "Size", 0.4)};
constexpr CatalogueMeasure helicoid_measures[] = {length_measure("radiusX", "Radius in x", 1),
                                                  length_measure("radiusY", "Radius in y", 1),
                                                  length_measure("rise", "Rise per radian", 0.15)};
constexpr CatalogueMeasure swallowtail_measures[] = {length_measure("size", "Size", 0.3)};
constexpr CatalogueMeasure whitney_measures[] = {length_measure("size", "Size", 0.15)};
constexpr CatalogueMeasure trianguloid_measures[] = {length_measure("size", "Size", 0.25)};

constexpr CatalogueSurfaceRow surface_rows[]{
    {"plane", "Plane", "plane", plane_measures, open_on(0, 1), open_on(0, 1),
     [](const double* m, const auto& u, const auto& v) {
       const auto coordinate = [&](int k) { return m[k] + m[k + 3] * u + m[k + 6] * v; };
       return point_of(coordinate(0), coordinate(1), coordinate(2));
     },
     true, check_plane},
    {"disc", "Disc", "disc", disc_measures, disc_u, turn,
     [](const double*, const auto& u, const auto& v) { return about_z(u, v, 0); }},
    {"cylinder", "Cylinder", "cylinder", cylinder_measures, open_on(-0.5, 0.5), closed_on(-1.5 * pi, 0.5 * pi),
     [](const double* m, const auto& u, const auto& v) { return point_of(m[0] * sin(v), m[1] * cos(v), m[2] * u); }},
    // To the apex and not beyond.
    {"cone", "Cone", "cone", cone_measures, cone_u, closed_on(-0.5 * pi, 1.5 * pi),
     [](const double* m, const auto& u, const auto& v) { return about_z(m[0] / m[1] * (m[1] - u), v, u); }},
    {"sphere", "Sphere", "sphere", sphere_measures, turn, between_poles(-0.5 * pi, 0.5 * pi),
     [](const double* m, const auto& u, const auto& v) { return about_z(m[0] * cos(v), u, m[0] * sin(v)); }},
    {"torus", "Torus", "torus", torus_measures, turn, turn,
     [](const double* m, const auto& u, const auto& v) { return about_z(m[0] + m[1] * cos(v), u, m[2] * sin(v)); }},
    {"asteroidal-sphere", "Asteroidal sphere", "asteroidal sphere", asteroidal_sphere_measures, turn,
     between_poles(-0.5 * pi, 0.5 * pi),
     [](const double* m, const auto& u, const auto& v) {
       const auto p = about_z(cos(v), u, sin(v));
       return point_of(integer_power(m[0] * p.x, 3), integer_power(m[1] * p.y, 3), integer_power(m[2] * p.z, 3));
     }},
    {"apple", "Apple", "apple", apple_measures, turn, open_on(apple_v.start, apple_v.end),
     [](const double* m, const auto& u, const auto& w) {
       const auto v = held(w, apple_v), s = sin(v), c = cos(v);
       const auto z = (c + s - 1) * (1 + s) * log(1 - pi / 10 * v) + 7.5 * s;
       return scaled(m[0], about_z(4 + 3.8 * c, u, z));
     }},
    {"second-apple", "Second apple", "second apple", second_apple_measures, turn_about_zero, between_poles(0, pi),
     [](const double* m, const auto& u, const auto& v) {
       const auto radius = 2 * m[0] * (1 + cos(v));
       return about_z(radius * sin(v), u, -radius * cos(v));
     }},
    {"seashell", "Seashell", "seashell", seashell_measures, turn, open_on(0.25 * pi, 5 * pi),
     [](const double* m, const auto& u, const auto& v) {
       const auto along = 1 + 0.1 * v * cos(u), across = 0.051449576 * v * sin(u);
       return scaled(m[0], along * cos(v) + across * sin(v), along * sin(v) - across * cos(v),
                     (0.6 + 0.085749293 * sin(u)) * v);
     }},
    {"bent-horns", "Bent horns", "bent-horn surface", bent_horns_measures, turn_about_zero, open_on(-2 * pi, 2 * pi),
     [](const double* m, const auto& u, const auto& v) {
       const auto bend = cos(v) - 1;
       return scaled(m[0], (2 + cos(u)) * (v / 3 - sin(v)), (2 + cos(u - third_of_turn)) * bend,
                     (2 + cos(u + third_of_turn)) * bend);
     }},
    {"bohemian-dome", "Bohemian dome", "Bohemian dome", bohemian_dome_measures, turn, turn,
     [](const double* m, const auto& u, const auto& v) {
       return point_of(m[0] * cos(u), m[0] * sin(u) + m[1] * cos(v), m[2] * sin(v));
     }},
    {"eight", "Eight surface", "eight surface", larger_size_measures, turn, eight_v,
     [](const double* m, const auto& u, const auto& v) {
       const auto z = m[0] * sin(v);
       return about_z(z * cos(v), u, z);
     }},
    {"sine", "Sine surface", "sine surface", size_measures, turn, turn,
     [](const double* m, const auto& u, const auto& v) { return scaled(m[0], sin(u), sin(v), sin(u + v)); }},
    {"moebius", "Möbius strip", "Möbius strip", moebius_measures, open_on(-1, 1), twisted_on(-0.5 * pi, 1.5 * pi, 0),
     [](const double* m, const auto& u, const auto& v) {
       const auto across = m[1] * u, half = 0.5 * v;
       return about_z(m[0] + across * cos(half), v, across * sin(half));
     }},
    {"klein-bottle", "Klein bottle", "Klein bottle", klein_bottle_measures, twisted_on(0, 2 * pi, pi), turn,
     [](const double* m, const auto& u, const auto& v) { return klein_bottle(m, u, v); }, false},
    {"figure-eight-klein-bottle", "Figure-eight Klein bottle", "figure-eight Klein bottle",
     figure_eight_klein_bottle_measures, twisted_on(0, 2 * pi, 0), turn,
     [](const double* m, const auto& u, const auto& v) {
       const auto c = m[1] * cos(0.5 * u), s = m[1] * sin(0.5 * u), a = sin(v), b = sin(2 * v);
       return about_z(m[0] * m[1] + c * a - s * b, u, s * a + c * b);
     }},
    // Apéry's map. Its denominator is at least 1 - 1/sqrt 2.
    {"boy", "Boy's surface", "Boy surface", size_measures, closed_on(0, pi), twisted_on(0, pi, pi),
     [](const double* m, const auto& u, const auto& v) {
       constexpr double root = std::numbers::sqrt2;
       const auto c = cos(u), s = 2.0 / 3 * sin(u), q = c / (1 - root * sin(u) * c * sin(3 * v)), p = root / 3 * c;
       return scaled(m[0], q * (p * cos(2 * v) + s * cos(v)), q * (p * sin(2 * v) - s * sin(v)), q * c - 1);
     }},
    {"cross-cap", "Cross-cap", "cross-cap", cross_cap_measures, closed_on(0, pi), twisted_on(0, pi, pi),
     [](const double* m, const auto& u, const auto& v) {
       const auto c = m[0] * cos(u), square = c * c;
       return point_of(m[0] * sin(u) * c * sin(v), square * sin(2 * v), square * cos(2 * v));
     }},
    // The Roman surface.
    {"steiner", "Steiner's surface", "Steiner surface", steiner_measures, twisted_on(0, pi, pi), closed_on(0, pi),
     [](const double* m, const auto& u, const auto& v) {
       const auto p = about_z(m[0] * cos(v), u, m[0] * sin(v));
       return point_of(p.x * p.y, p.y * p.z, p.z * p.x);
     }},
    // Of constant Gaussian curvature, as Kuen's.
    {"dini", "Dini's surface", "Dini surface", dini_measures, open_on(0, 4 * pi), open_on(dini_v.start, dini_v.end),
     [](const double* m, const auto& u, const auto& w) {
       const auto v = held(w, dini_v);
       return about_z(m[0] * sin(v), u, m[0] * (cos(v) + log_tan_half(v)) + m[1] * u);
     }},
    {"kuen", "Kuen's surface", "Kuen surface", kuen_measures, open_on(-4, 4), open_on(kuen_v.start, kuen_v.end),
     [](const double* m, const auto& u, const auto& w) {
       const auto v = held(w, kuen_v), q = 2 * m[0] / (1 + integer_power(u * sin(v), 2)), r = q * sin(v);
       return point_of(r * (cos(u) + u * sin(u)), r * (sin(u) - u * cos(u)), m[0] * log_tan_half(v) + q * cos(v));
     }},
    // Minimal surfaces both.
    // [enneper]
    {"enneper", "Enneper's surface", "Enneper surface", enneper_measures, open_on(-1.5, 1.5), open_on(-1.5, 1.5),
     [](const double* m, const auto& u, const auto& v) {
       const auto a = u * u, b = v * v;
       return scaled(m[0], u * (1 - a / 3 + b), v * (b / 3 - a - 1), a - b);
     }},
    // [/enneper]
    {"helicoid", "Helicoid", "helicoid", helicoid_measures, open_on(0, 15), open_on(-1, 1),
     [](const double* m, const auto& u, const auto& v) {
       return point_of(m[0] * v * sin(u), m[1] * v * cos(u), m[2] * u);
     }},
    {"swallowtail", "Swallowtail", "swallowtail", swallowtail_measures, open_on(-2, 2), open_on(-0.8, 0.8),
     [](const double* m, const auto& u, const auto& v) {
       const auto square = v * v;
       return scaled(m[0], square * (u + 3 * square), -2 * v * (u + 2 * square), u);
     }},
    {"whitney-umbrella", "Whitney's umbrella", "Whitney umbrella", whitney_measures, open_on(-pi, pi), open_on(-pi, pi),
     [](const double* m, const auto& u, const auto& v) { return scaled(m[0], u * v, u, v * v); }},
    {"trianguloid-trefoil", "Trianguloid trefoil", "trianguloid trefoil", trianguloid_measures, turn_about_zero,
     turn_about_zero,
     [](const double* m, const auto& u, const auto& v) {
       const auto p = 2 + cos(v), q = 2 + cos(v + third_of_turn);
       return scaled(m[0], 2 * sin(3 * u) / p, 2 * (sin(u) + 2 * sin(2 * u)) / q,
                     0.25 * (cos(u) - 2 * cos(2 * u)) * p * q);
     }},
    {"slippers", "Slippers", "slipper surface", larger_size_measures, turn, turn,
     [](const double* m, const auto& u, const auto& v) {
       return scaled(m[0], slippers_coordinate(u, v, 3, 1),
                     slippers_coordinate(u + third_of_turn, v + third_of_turn, 2, 2),
                     slippers_coordinate(u - third_of_turn, v - third_of_turn, 2, 3));
     }},
};

const CatalogueSurfaceRow& row_of(const CatalogueSurface& surface) { return surface_rows[surface.row]; }

int row_index(std::string_view id) { return static_cast<int>(find_catalogue_surface(id) - surface_rows); }

}  // namespace

std::span<const CatalogueSurfaceRow> surface_catalogue() { return surface_rows; }

const CatalogueSurfaceRow* find_catalogue_surface(std::string_view id) { return find_row(surface_catalogue(), id); }

Result<CatalogueSurface> make_catalogue_surface(std::string_view id, std::span<const double> measures) {
  const CatalogueSurfaceRow* row = find_catalogue_surface(id);
  if (row == nullptr) return Error{"id", "There is no such surface in the catalogue."};
  const Result<CatalogueMeasures> read = read_measures(row->measures, row->check, measures);
  if (!read) return read.error();
  return CatalogueSurface{static_cast<int>(row - surface_rows), read.value()};
}

CatalogueSurface plane_surface(const Eigen::Vector3d& origin, const Eigen::Vector3d& u_axis,
                               const Eigen::Vector3d& v_axis) {
  CatalogueSurface surface{row_index("plane")};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto coordinate = static_cast<Eigen::Index>(k);
    surface.measures[k] = origin[coordinate];
    surface.measures[k + 3] = u_axis[coordinate];
    surface.measures[k + 6] = v_axis[coordinate];
  }
  return surface;
}

CatalogueSurface cylinder_surface(double radius_x, double radius_y, double height) {
  return {row_index("cylinder"), {radius_x, radius_y, height}};
}

CatalogueSurface torus_surface(double wheel_radius, double tube_radius, double tube_height) {
  return {row_index("torus"), {wheel_radius, tube_radius, tube_height}};
}

Status validate(const CatalogueSurface& surface) {
  if (surface.row < 0 || surface.row >= static_cast<int>(std::size(surface_rows))) {
    return Error{"row", "There is no such surface in the catalogue."};
  }
  const CatalogueSurfaceRow& row = row_of(surface);
  return check_measures(row.measures, row.check, surface.measures);
}

SurfaceDomain domain(const CatalogueSurface& surface) {
  const auto interval = [&](const CatalogueDirection& direction) {
    const double unit = direction.unit < 0 ? 1 : surface.measures[static_cast<std::size_t>(direction.unit)];
    return Interval{unit * direction.domain.start, unit * direction.domain.end};
  };
  const CatalogueSurfaceRow& row = row_of(surface);
  return {interval(row.u), interval(row.v), row.u.closure, row.v.closure, row.u.reflection, row.v.reflection};
}

SurfaceJet evaluate(const CatalogueSurface& surface, double u, double v) {
  return jet(row_of(surface).formula.taylor2(surface.measures.data(), Taylor2::variable_u(u), Taylor2::variable_v(v)));
}

PointOf<MixedSeries> series_of(const CatalogueSurface& surface, const MixedSeries& u, const MixedSeries& v) {
  return row_of(surface).formula.mixed(surface.measures.data(), u, v);
}

void evaluate_grid(const CatalogueSurface& surface, std::span<const double> u, std::span<const double> v,
                   std::span<SurfaceJet> out) {
  assert(out.size() == u.size() * v.size());
  std::size_t k = 0;
  for (const double a : u) {
    for (const double b : v) out[k++] = evaluate(surface, a, b);
  }
}

}  // namespace knotwork
