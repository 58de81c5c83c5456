#pragma once

#include <optional>
#include <span>
#include <vector>

#include "knotwork/curve/continuity.h"
#include "knotwork/later.h"
#include "web/curvature_comb.h"

namespace knotwork::web {

/// The derivative of a curve as a curve of its own, laid beside it.
struct Hodograph {
  struct Place {
    glm::vec3 at;
    bool ends_piece;  ///< the next place belongs to another piece of the curve
  };
  std::vector<Place> places;  ///< origin + scale * c'(t)
  glm::dvec3 origin{0};
  double scale = 1;  ///< drawn length by |c'|: one over 1, 2 or 5 times a power of ten
};

/// What is shown about a curve beside its figure, made once for each state of the curve.
struct CurveTools {
  std::vector<CombHair> comb;
  Hodograph hodograph;
  std::vector<Continuity> joints;
  double size = 0;               ///< of the curve's box, its diagonal; for the osculating circle alone
  std::vector<glm::dvec3> tips;  ///< what needs room in the picture when all of it is shown
};

/// The tools that `display` asks for; nothing of a surface. Each stays empty when it is not asked for.
KNOTWORK_LAST CurveTools curve_tools(const Figure& figure, const scene::Display& display);
/// Whether display asks for any.
bool wants_tools(const scene::Display& display);

/// Comb, hodograph with the velocity at the parameter, and the osculating circle there.
KNOTWORK_LAST void add_tools(Picture& picture, const Figure& figure, const CurveTools& tools);

/// Beside each joint how smooth it is, "C² " or "C⁰ G²"; beside the hodograph its scale, "c′ ÷ 5".
KNOTWORK_LAST void add_tool_labels(std::vector<StageLabel>& labels, const Figure& figure, const scene::Display& display,
                                   const CurveTools& tools, const View& view, const Theme& theme);

/// "C²", or "C⁰ G²" where the shape is smoother than the parameter; at most the order that continuity_at() looks at.
std::string continuity_text(const Continuity& joint);

/// The circle of a point, its centre, in the plane of the unit tangent and normal there; nothing where it is larger than
/// twice the size of the curve (its box's diagonal): it would be a line through the picture.
void add_osculating_circle(Picture& picture, const glm::dvec3& centre, double radius, const glm::dvec3& tangent,
                           const glm::dvec3& normal, double size);

}  // namespace knotwork::web
