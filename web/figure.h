#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "knotwork/later.h"
#include "knotwork/scene/blending_curve_figure.h"
#include "knotwork/scene/curve_figure.h"
#include "knotwork/scene/document.h"
#include "knotwork/scene/fit_figure.h"
#include "knotwork/scene/model_curve_figure.h"
#include "knotwork/scene/model_figure.h"
#include "knotwork/scene/net_figure.h"
#include "knotwork/scene/picking.h"
#include "knotwork/scene/subdivision_figure.h"
#include "knotwork/scene/surface_builder.h"
#include "web/camera.h"

namespace knotwork::web {

/// The blending surface as it stands on the stage, rolling included.
struct BlendingFigure {
  explicit BlendingFigure(BlendingSurface made) : surface(std::move(made)), axes(scene::patch_frames(surface)) {}

  BlendingSurface surface;
  std::vector<Eigen::Matrix3d> axes;  ///< the locals' own frames: what moves them does not change these
  std::optional<scene::PickNet> net;  ///< made when first asked for: it costs as much as a mesh
};

/// A B-spline surface with its net, rolling included.
struct NetSurfaceFigure {
  scene::NetFigure shown;
  std::optional<scene::PickNet> net;  ///< made when first asked for
};

/// A surface of the catalogue by itself.
struct ModelSurfaceFigure {
  scene::ModelFigure shown;
  std::optional<scene::PickNet> net;  ///< made when first asked for
};

/// What stands on the stage: all that is drawn of an object, held or read off, made from its shape once for each
/// revision. A kind of figure comes with
///
///   here                 handles_of, outline, path_of
///   figure_picture.h     add_to_picture, labels_of
///   figure_panel.h       size_text, strip_height, draw_strip, draw_readout, tools_of
using Figure = std::variant<BlendingFigure, scene::CurveFigure, scene::FitFigure, scene::SubdivisionFigure,
                            scene::ModelCurveFigure, scene::BlendingCurveFigure, NetSurfaceFigure, ModelSurfaceFigure>;

/// The figure of a shape at rest. Precondition: the document passes check().
Figure make_figure(const scene::Shape& shape, const scene::Animation& animation);
/// The same into `figure`, of which what still holds may be kept.
KNOTWORK_LATER void update_figure(std::optional<Figure>& figure, const scene::Shape& shape,
                                  const scene::Animation& animation);

/// Whether the shape rolls from one topology to another, and how far its directions are closed at rest.
bool rolls(const scene::Shape& shape);
scene::Roll roll_at_rest(const scene::Shape& shape);

/// Whether the figure changes with the clock.
bool moves(const scene::Shape& shape);
/// Whether both are of one kind, but made from different models.
KNOTWORK_LATER bool is_other_model(const scene::Shape& shape, const scene::Shape& last);

/// Which handle of what is on the stage: (i, j) of a local patch, (i, 0) of a curve's point or local curve, or the curve's
/// parameter.
using HandleIndex = scene::PatchIndex;
inline constexpr HandleIndex parameter_handle{-1, 0};

/// Which handles a shape has: (i, j) with 0 <= i < columns, 0 <= j < rows, and the parameter's.
struct HandleGrid {
  std::string_view id;    ///< as `patch`
  std::string_view name;  ///< for readers, as `Patch`
  int columns, rows;
  bool two_indices;    ///< named (i, j), else i alone
  bool has_parameter;  ///< a point that slides along the curve
};
HandleGrid handle_grid(const scene::Shape& shape);

/// The id of handles() in the script interface: "patch-2-1", "local-3", "point-3", "parameter".
std::string handle_id(const scene::Shape& shape, HandleIndex index);
/// The handle with this id, if the shape has it.
std::optional<HandleIndex> find_handle(const scene::Shape& shape, std::string_view id);
/// For readers: "Patch 2, 1", "Point 3", "Parameter".
std::string handle_name(const scene::Shape& shape, HandleIndex index);
/// Whether the shape has such a handle.
bool has_handle(const scene::Shape& shape, HandleIndex index);

/// A handle as it stands on the stage.
struct Handle {
  HandleIndex index;
  glm::dvec3 position;
  std::optional<glm::dvec3> screen;  ///< nothing when behind the camera
  bool hidden = false;               ///< something lies in front of it
};

/// In the order of drawing and finding: of two in one place the first is meant.
void take_handles(const Figure& figure, const scene::Shape& shape, std::vector<Handle>& handles);

/// Points that say how large the figure is: enough to place its picture.
std::vector<glm::dvec3> outline(const Figure& figure);
std::vector<glm::dvec3> outline(const KnottedSurface& surface);

/// The surface of the figure; nothing for a curve. It refers to the figure.
std::optional<KnottedSurface> surface_of(const Figure& figure);
/// Where a ray meets it.
std::optional<scene::SurfaceHit> pick(Figure& figure, const scene::Ray& ray);

/// The curve that the parameter slides along; empty where there is none.
std::span<const scene::CurveSample> path_of(const Figure& figure);

}  // namespace knotwork::web
