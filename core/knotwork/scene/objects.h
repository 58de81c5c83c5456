#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "knotwork/basis/blending_function.h"
#include "knotwork/basis/knot_vector.h"
#include "knotwork/curve/blending_curve.h"
#include "knotwork/curve/curve_catalogue.h"
#include "knotwork/curve/curve_fit.h"
#include "knotwork/later.h"
#include "knotwork/scene/models.h"
#include "knotwork/surface/blending_surface.h"

namespace knotwork::scene {

/// A reader's edit of one local patch, in the patch's own frame: x along S_u of the model at the patch's centre,
/// z along the normal. M_ij = Translation(centre + F translation) F rotation scale F^-1, so that an edit keeps its
/// meaning ("outwards", "about the normal") while the model bends.
struct PatchEdit {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();         ///< model units
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< unit to 1e-6
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();               ///< each in [0.01, 100]

  bool is_identity() const;
  bool operator==(const PatchEdit& other) const;
};

/// Which local patch: (i, j) with 0 <= i < n_u, 0 <= j < n_v.
using PatchIndex = std::pair<int, int>;

struct BlendingSurfaceObject {
  ModelSurface model = Sheet{};  ///< the bends of a Sheet are ignored: they follow the topology
  Topology topology_u = Topology::closed, topology_v = Topology::closed;
  int locals_u = 6, locals_v = 4;
  LocalSurfaces patches;  ///< degrees without meaning for sub-surfaces
  BlendingKind blending = BlendingKind::polynomial2;
  int blending_parameter = 2;  ///< m or p; without meaning where the family has none
  int samples_u = 144, samples_v = 96;
  /// Only edited patches are listed. Edits beyond the present counts are kept and sleep.
  std::map<PatchIndex, PatchEdit> edits;

  bool operator==(const BlendingSurfaceObject&) const = default;
};

/// Why the directions cannot be closed as the object has it: a turn in a twisted direction reflects the patches along
/// the other one, which must lie so that they fall onto each other. `member` of the document is at fault. The message is
/// empty when they can. Precondition: no direction is closed in which the model is not.
struct SeamProblem {
  std::string member, message;
};
SeamProblem seam_problem(const BlendingSurfaceObject& object);
/// The same for a model that twists; only with such a one can there be a problem.
KNOTWORK_LATER SeamProblem twisted_seam_problem(const BlendingSurfaceObject& object);
bool twists(const ModelSurface& model);

/// A Bezier curve by its control points, model units; its degree is their number less one.
struct BezierCurveObject {
  std::vector<Eigen::Vector3d> points{{0, 0, 0}, {1, 0, 0}};
  double parameter = 0.5;  ///< where de Casteljau's construction is shown: share of the domain

  bool operator==(const BezierCurveObject&) const = default;
};

/// A B-spline curve by knots and control points, as KnotVector and BSplineCurve take them.
struct BSplineCurveObject {
  int degree = 1;
  Topology topology = Topology::open;
  std::vector<double> knots{0, 0, 1, 1};
  std::vector<Eigen::Vector3d> points{{0, 0, 0}, {1, 0, 0}};
  double parameter = 0.5;  ///< where de Boor's construction is shown: share of the domain

  bool operator==(const BSplineCurveObject&) const = default;
};

/// Where a fitted curve passes its data: steps in proportion to |p_j - p_{j-1}|^0, ^(1/2) or ^1.
enum class DataParameters : unsigned char { uniform, centripetal, chord_length };
/// Whether an open fitted curve begins and ends at the first and the last of its data.
enum class FitEnds : unsigned char { free, interpolated };

/// The least-squares curve near its data, as fit_curve() makes it: the points are given, not the curve's own.
struct FittedCurveObject {
  std::vector<Eigen::Vector3d> points{{0, 0, 0}, {1, 0, 0}};  ///< the data, model units, in order
  int degree = 1;
  Topology topology = Topology::open;
  int count = 2;  ///< n, control points
  DataParameters parameters = DataParameters::uniform;
  KnotPlacement knots = KnotPlacement::even;
  FitEnds ends = FitEnds::free;  ///< without meaning, and kept, while the curve is closed
  double smoothing = 0;

  bool operator==(const FittedCurveObject&) const = default;
};

/// A polygon on its way to a curve (lane_riesenfeld.h). A level has degree + 1 steps: the split, then the averaging
/// passes.
struct SubdivisionCurveObject {
  std::vector<Eigen::Vector3d> points{{0, 0, 0}, {1, 0, 0}};  ///< of the polygon at the start, model units
  int degree = 1;
  Topology topology = Topology::open;
  int levels = 0;       ///< how far the walk goes
  int step = 0;         ///< steps done, 0 to levels (degree + 1)
  double fraction = 0;  ///< how much of the next step, in [0,1]; 0 after the last
  bool limit = true;    ///< whether the limit curve is shown

  bool operator==(const SubdivisionCurveObject&) const = default;
};

/// A curve of the catalogue with its standard measures, and the one that a document starts with: the report's.
CatalogueCurve standard_curve(int row);
CatalogueCurve standard_model_curve();

/// A curve of the catalogue.
struct ModelCurveObject {
  CatalogueCurve model = standard_model_curve();
  double parameter = 0.5;  ///< where the frame is shown: share of the domain

  bool operator==(const ModelCurveObject&) const = default;
};

/// A blending curve over a curve of the catalogue, as BlendingCurve takes it.
struct BlendingCurveObject {
  CatalogueCurve model = standard_model_curve();
  Topology topology = Topology::closed;
  int locals = 10;
  LocalCurveKind local_kind = LocalCurveKind::sub_curve;
  int local_degree = 3;  ///< of Bezier-Hermite locals; without meaning for others
  BlendingKind blending = BlendingKind::polynomial2;
  int blending_parameter = 2;  ///< m or p; without meaning where the family has none
  /// The knots strictly between the ends of the domain, as shares of it; none: evenly spaced ones. When closed, the
  /// centre of local 0 is at the start of the domain and these are the others': n-1; when open, n-2.
  std::vector<double> knots;
  /// Only edited locals are listed, local k as (k, 0), in the frame of local_frames(). Edits beyond the present count
  /// are kept and sleep.
  std::map<PatchIndex, PatchEdit> edits;
  double parameter = 0.5;  ///< where the two locals are shown at work: share of the domain

  bool operator==(const BlendingCurveObject&) const = default;
};

/// One direction of a tensor-product surface: knots as KnotVector takes them.
struct SplineDirection {
  int degree = 1;
  Topology topology = Topology::open;
  std::vector<double> knots{0, 0, 1, 1};

  bool operator==(const SplineDirection&) const = default;
};

/// Rows of control points, net[i][j] = c_ij: i counts along u, and row i runs along v. All rows are of one length.
using Net = std::vector<std::vector<Eigen::Vector3d>>;

/// A tensor-product B-spline surface by knots and net, as BSplineSurface takes them. Without inner knots it is a Bezier
/// surface.
struct BSplineSurfaceObject {
  SplineDirection u, v;
  Net net{{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 0}}};  ///< model units
  int samples_u = 144, samples_v = 96;
  /// What carries the net while a direction closes or opens (net_roll.h); its bends are ignored: they follow the
  /// topology.
  Sheet sheet;

  int rows() const { return static_cast<int>(net.size()); }
  int columns() const { return static_cast<int>(net.front().size()); }
  bool operator==(const BSplineSurfaceObject&) const = default;
};

/// A surface of the catalogue by itself; any model but the sheet, which follows a topology.
struct ModelSurfaceObject {
  ModelSurface model = CatalogueSurface{0, {-1, -1, 0, 2, 0, 0, 0, 2, 0}};  ///< the catalogue's plane
  int samples_u = 144, samples_v = 96;

  bool operator==(const ModelSurfaceObject&) const = default;
};

/// In the order of ShapeKind.
using Shape = std::variant<BlendingSurfaceObject, BezierCurveObject, BSplineCurveObject, FittedCurveObject,
                           SubdivisionCurveObject, ModelCurveObject, BlendingCurveObject, BSplineSurfaceObject,
                           ModelSurfaceObject>;
enum class ShapeKind : unsigned char {
  blending_surface,
  bezier_curve,
  bspline_curve,
  fitted_curve,
  subdivision_curve,
  model_curve,
  blending_curve,
  bspline_surface,
  model_surface
};

/// One row of the table of what an object can be.
struct ShapeRow {
  std::string_view id;     ///< in documents, as `blendingSurface`
  std::string_view label;  ///< for readers, as `Blending surface`
};
std::span<const ShapeRow> shape_kinds();
KNOTWORK_LATER Shape make_shape(ShapeKind kind);

struct Object {
  std::string id;  ///< unique, [a-z][a-z0-9-]*
  std::string label;
  Shape shape;

  ShapeKind kind() const { return static_cast<ShapeKind>(shape.index()); }
  bool operator==(const Object&) const = default;
};

}  // namespace knotwork::scene
