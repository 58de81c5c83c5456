#pragma once

#include "web/interface_widgets.h"

namespace knotwork::web {

/// What a hand did to the strip.
struct StripEvent {
  bool taken = false, let_go = false;
  std::optional<double> t;                     ///< where the parameter was moved to
  std::optional<std::pair<int, double>> knot;  ///< index and value
};

/// The basis functions over the parameter line as bumps in their control points' hues, their sum, the parameter as a
/// line through all, and the knots as triangles that stack where they coincide. A press on the bumps moves the
/// parameter; a knot is dragged, and snaps to its neighbours.
/// `height` of the plot alone; the knots take `strip_foot` below it. `held` is the point whose bump is lit.
StripEvent knot_strip(Interface& ui, const Rect& rect, const scene::CurveFigure& figure, bool movable,
                      std::optional<int> held, KnotDrag& drag);

/// What one of several strips on the stage is told moreover.
struct StripOptions {
  std::string_view letter = "t";    ///< of the parameter: its knots are t₀, t₁ ...
  std::string_view prefix;          ///< of its widgets' labels
  std::span<const Colour> hues;     ///< of the points; none: point_hue()
  std::optional<double> parameter;  ///< the line through all bumps is there, or nowhere
};
StripEvent knot_strip(Interface& ui, const Rect& rect, const scene::CurveFigure& figure, bool movable,
                      std::optional<int> held, KnotDrag& drag, const StripOptions& options);

}  // namespace knotwork::web
