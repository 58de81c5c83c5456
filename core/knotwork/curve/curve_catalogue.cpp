#include "knotwork/curve/curve_catalogue.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "knotwork/basis/integer_power.h"

namespace knotwork {
namespace {

using std::numbers::pi;

/// At the angle t, `radius` away from the origin.
Taylor3Point polar(const Taylor3& radius, const Taylor3& t) { return {radius * cos(t), radius * sin(t), 0}; }

/// t less its whole turns, exact to the last digit: a multiple of many turns would carry as many times t's rounding.
/// 2pi comes in two parts, of which the first, a float, times a number of turns is exact.
Taylor3 within_turn(Taylor3 t) {
  constexpr double high = static_cast<float>(2 * pi), low = -1.748455600074497e-7;
  const double turns = std::floor(t.value / (2 * pi));
  t.value = (t.value - turns * high) - turns * low;
  return t;
}

Interval one_turn(const double*) { return {0, 2 * pi}; }
Interval two_turns(const double*) { return {0, 4 * pi}; }

/// b / gcd(a, b): how many turns it takes until a/b of each turn makes whole turns.
double turns_to_meet(double a, double b) { return b / std::gcd(static_cast<int>(a), static_cast<int>(b)); }

/// n/m in lowest terms: m half turns on, the direction has the sign (-1)^m and cos(nt/m) has (-1)^n. These cancel when
/// both are odd; otherwise it takes m whole turns.
Interval rose_period(const double* m) {
  const double numerator = turns_to_meet(m[1], m[0]), denominator = turns_to_meet(m[0], m[1]);
  const bool both_odd = std::fmod(numerator * denominator, 2) == 1;
  return {0, denominator * (both_odd ? pi : 2 * pi)};
}

Status check_line(const double* m) {
  if (std::hypot(m[3], m[4], m[5]) < shortest_length)
    return Error{"directionX", "The direction of the line must not be zero."};
  return success();
}

constexpr CatalogueMeasure radius_measures[] = {length_measure("radius", "Radius", 1)};
constexpr CatalogueMeasure line_measures[] = {
    coordinate_measure("originX", "Origin x", -1),      coordinate_measure("originY", "Origin y", -0.5),
    coordinate_measure("originZ", "Origin z", 0),       coordinate_measure("directionX", "Direction x", 2),
    coordinate_measure("directionY", "Direction y", 1), coordinate_measure("directionZ", "Direction z", 0)};
constexpr CatalogueMeasure arc_measures[] = {length_measure("speed", "Speed", 1),
                                             length_measure("curvature", "Curvature", 1)};
constexpr CatalogueMeasure rose_measures[] = {count_measure("numerator", "Numerator", 7),
                                              count_measure("denominator", "Denominator", 4),
                                              length_measure("radius", "Radius", 1.5)};
constexpr CatalogueMeasure butterfly_measures[] = {length_measure("size", "Size", 0.4)};
constexpr CatalogueMeasure chrysanthemum_measures[] = {length_measure("size", "Size", 0.15)};
constexpr CatalogueMeasure report_measures[] = {length_measure("size", "Size", 1)};
constexpr CatalogueMeasure helix_measures[] = {length_measure("radius", "Radius", 1),
                                               length_measure("rise", "Rise per radian", 0.1),
                                               length_measure("turns", "Turns", 3)};
constexpr CatalogueMeasure heart_measures[] = {length_measure("size", "Size", 0.08)};
constexpr CatalogueMeasure astroid_measures[] = {length_measure("radius", "Radius", 1.5)};
constexpr CatalogueMeasure nephroid_measures[] = {length_measure("radius", "Radius of the rolling circle", 0.4)};
constexpr CatalogueMeasure epitrochoid_measures[] = {
    count_measure("fixedTeeth", "Fixed teeth", 3), count_measure("rollingTeeth", "Rolling teeth", 1),
    length_measure("penDistance", "Pen distance", 2), length_measure("size", "Size of a tooth", 0.25)};
constexpr CatalogueMeasure lissajous_measures[] = {
    count_measure("frequencyX", "Frequency in x", 3), count_measure("frequencyY", "Frequency in y", 2),
    count_measure("frequencyZ", "Frequency in z", 5), angle_measure("phaseX", "Phase in x", 0.5),
    angle_measure("phaseZ", "Phase in z", 1),         length_measure("size", "Size", 1)};
constexpr CatalogueMeasure trefoil_measures[] = {length_measure("size", "Size", 0.5)};
constexpr CatalogueMeasure torus_knot_measures[] = {
    count_measure("turnsAround", "Turns around", 2), count_measure("turnsThrough", "Turns through", 3),
    length_measure("wheelRadius", "Wheel radius", 1), length_measure("tubeRadius", "Tube radius", 0.4)};
constexpr CatalogueMeasure viviani_measures[] = {length_measure("radius", "Radius of the cylinder", 0.8)};
constexpr CatalogueMeasure clelia_measures[] = {length_measure("radius", "Radius of the sphere", 1.5),
                                                count_measure("frequency", "Frequency", 3)};

constexpr CatalogueCurveRow curve_rows[]{
    {"circle", "Circle", radius_measures, Topology::closed, one_turn,
     [](const double* m, const Taylor3& t) { return polar(m[0], t); }},
    {"line", "Line", line_measures, Topology::open,
     [](const double*) {
       return Interval{0, 1};
     },
     [](const double* m, const Taylor3& t) {
       return Taylor3Point{m[0] + m[3] * t, m[1] + m[4] * t, m[2] + m[5] * t};
     },
     check_line},
    // From the origin along +x, to the left. The whole turn.
    {"arc", "Arc", arc_measures, Topology::closed,
     [](const double* m) {
       return Interval{0, 2 * pi / (m[0] * m[1])};
     },
     [](const double* m, const Taylor3& t) {
       const double radius = 1 / m[1];
       const Taylor3 angle = m[0] * m[1] * t;
       return Taylor3Point{radius * sin(angle), radius * (1 - cos(angle)), 0};
     }},
    {"rose", "Rose", rose_measures, Topology::closed, rose_period,
     [](const double* m, const Taylor3& t) { return polar(m[2] * cos(m[0] / m[1] * t), t); }},
    {"butterfly", "Butterfly", butterfly_measures, Topology::closed,
     [](const double*) {
       return Interval{0, 24 * pi};
     },
     [](const double* m, const Taylor3& t) {
       return polar(m[0] * (exp(cos(t)) - 2 * cos(4 * t) - integer_power(sin(t / 12), 5)), t);
     }},
    {"chrysanthemum", "Chrysanthemum", chrysanthemum_measures, Topology::closed,
     // Plotted to 21 pi in the literature, where it is not closed.
     [](const double*) {
       return Interval{0, 30 * pi};
     },
     [](const double* m, const Taylor3& t) {
       const Taylor3 s = within_turn(t);
       const Taylor3 leaf = integer_power(sin(17 * t / 3), 4) * integer_power(sin(2 * cos(3 * s) - 28 * s), 8);
       return polar(m[0] * (5 * (1 + sin(11 * t / 5)) - 4 * leaf), t);
     }},
    {"report-curve", "The report's curve", report_measures, Topology::closed, one_turn,
     [](const double* m, const Taylor3& t) {
       return Taylor3Point{m[0] * (cos(t) + 0.5 * cos(3 * t)), m[0] * (sin(t) + 0.5 * sin(3 * t - 1)),
                           m[0] * (sin(t) + 0.3 * sin(5 * t))};
     }},
    {"helix", "Helix", helix_measures, Topology::open,
     [](const double* m) {
       return Interval{0, 2 * pi * m[2]};
     },
     [](const double* m, const Taylor3& t) {
       return Taylor3Point{m[0] * cos(t), m[0] * sin(t), m[1] * t};
     }},
    {"heart", "Heart", heart_measures, Topology::closed, one_turn,
     [](const double* m, const Taylor3& t) {
       return Taylor3Point{m[0] * (16 * integer_power(sin(t), 3)),
                           m[0] * (13 * cos(t) - 5 * cos(2 * t) - 2 * cos(3 * t) - cos(4 * t)), 0};
     }},
    {"astroid", "Astroid", astroid_measures, Topology::closed, one_turn,
     [](const double* m, const Taylor3& t) {
       return Taylor3Point{m[0] * integer_power(cos(t), 3), m[0] * integer_power(sin(t), 3), 0};
     }},
    {"nephroid", "Nephroid", nephroid_measures, Topology::closed, one_turn,
     [](const double* m, const Taylor3& t) {
       return Taylor3Point{m[0] * (3 * cos(t) - cos(3 * t)), m[0] * (3 * sin(t) - sin(3 * t)), 0};
     }},
    {"epitrochoid", "Epitrochoid", epitrochoid_measures, Topology::closed,
     [](const double* m) {
       return Interval{0, 2 * pi * turns_to_meet(m[0], m[1])};
     },
     [](const double* m, const Taylor3& t) {
       const double centre = m[0] + m[1];
       const Taylor3 pen = centre / m[1] * t;
       return Taylor3Point{m[3] * (centre * cos(t) - m[2] * cos(pen)), m[3] * (centre * sin(t) - m[2] * sin(pen)), 0};
     }},
    {"lissajous", "Lissajous curve", lissajous_measures, Topology::closed, one_turn,
     [](const double* m, const Taylor3& t) {
       return Taylor3Point{m[5] * sin(m[0] * t + m[3]), m[5] * sin(m[1] * t), m[5] * sin(m[2] * t + m[4])};
     }},
    {"trefoil-knot", "Trefoil knot", trefoil_measures, Topology::closed, one_turn,
     [](const double* m, const Taylor3& t) {
       return Taylor3Point{m[0] * (sin(t) + 2 * sin(2 * t)), m[0] * (cos(t) - 2 * cos(2 * t)), -m[0] * sin(3 * t)};
     }},
    {"torus-knot", "Torus knot", torus_knot_measures, Topology::closed, one_turn,
     [](const double* m, const Taylor3& t) {
       Taylor3Point knot = polar(m[2] + m[3] * cos(m[1] * t), m[0] * t);
       knot.z = m[3] * sin(m[1] * t);
       return knot;
     }},
    // Where a sphere of radius 2a meets a cylinder of radius a through its centre.
    {"viviani", "Viviani's curve", viviani_measures, Topology::closed, two_turns,
     [](const double* m, const Taylor3& t) {
       return Taylor3Point{m[0] * (1 + cos(t)), m[0] * sin(t), 2 * m[0] * sin(t / 2)};
     }},
    {"clelia", "Clelia", clelia_measures, Topology::closed, one_turn,
     [](const double* m, const Taylor3& t) {
       Taylor3Point clelia = polar(m[0] * sin(m[1] * t), t);
       clelia.z = m[0] * cos(m[1] * t);
       return clelia;
     }},
};

const CatalogueCurveRow& row_of(const CatalogueCurve& curve) { return curve_rows[curve.row]; }

}  // namespace

std::span<const CatalogueCurveRow> curve_catalogue() { return curve_rows; }

const CatalogueCurveRow* find_catalogue_curve(std::string_view id) { return find_row(curve_catalogue(), id); }

Result<CatalogueCurve> make_catalogue_curve(std::string_view id, std::span<const double> measures) {
  const CatalogueCurveRow* row = find_catalogue_curve(id);
  if (row == nullptr) return Error{"id", "There is no such curve in the catalogue."};
  const Result<CatalogueMeasures> read = read_measures(row->measures, row->check, measures);
  if (!read) return read.error();
  return CatalogueCurve{static_cast<int>(row - curve_rows), read.value()};
}

Status validate(const CatalogueCurve& curve) {
  if (curve.row < 0 || curve.row >= static_cast<int>(std::size(curve_rows))) {
    return Error{"row", "There is no such curve in the catalogue."};
  }
  const CatalogueCurveRow& row = row_of(curve);
  return check_measures(row.measures, row.check, curve.measures);
}

Interval domain(const CatalogueCurve& curve) { return row_of(curve).domain(curve.measures.data()); }

void evaluate(const CatalogueCurve& curve, double t, std::span<Eigen::Vector3d> out) {
  derivatives(row_of(curve).formula(curve.measures.data(), Taylor3::variable(t)), out);
}

void evaluate(const CatalogueCurve& curve, std::span<const double> t, int order, std::span<Eigen::Vector3d> out) {
  const std::size_t values = static_cast<std::size_t>(order) + 1;
  assert(out.size() == t.size() * values);
  for (std::size_t m = 0; m < t.size(); ++m) evaluate(curve, t[m], out.subspan(m * values, values));
}

}  // namespace knotwork
