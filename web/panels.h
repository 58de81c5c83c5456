#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "knotwork/scene/commands.h"
#include "knotwork/surface/surface_measures.h"
#include "web/figure.h"
#include "web/surface_quality.h"
#include "web/theme.h"

namespace knotwork::web {

/// An item drawn last, for the script interface's widgets(): label and rectangle in CSS pixels of the stage.
struct Widget {
  std::string label;
  std::array<double, 4> rect;  ///< x y width height
};

/// A word on the stage.
struct StageLabel {
  std::string words;
  glm::dvec2 place;  ///< CSS pixels, of its middle
  Colour colour;
};

/// The knot in the hand.
struct KnotDrag {
  bool held = false, moved = false;
  int first = 0, last = 0;  ///< the knots that coincided where it was taken
  int index = 0;            ///< the one that moves; chosen by the first direction
  float start = 0;          ///< of the pointer, CSS pixels
};

/// The probe under the pointer: parameters, point and curvatures.
struct SurfacePlace {
  double u, v;
  Eigen::Vector3d point;
  SurfaceCurvature curved;
};

/// Of a blending surface, with the weights of the four local patches at work.
struct Probe {
  SurfacePlace place;
  std::array<BlendingSurface::Weight, 4> weights;
  double blend_w_u;  ///< w in [0,1] in the u interval: the dot on the plot of B
};

/// All that the panels show. They change nothing; what the reader asks for comes back as commands.
struct PanelInput {
  const scene::Document& document;
  const Figure& figure;
  const Theme& theme;
  Viewport viewport;                  ///< insets ignored
  bool phone = false;                 ///< narrow stage: the panel is a drawer
  std::optional<glm::dvec2> pointed;  ///< the parameters under the pointer: (u, v), of a curve (t, 0)
  std::optional<HandleIndex> selected;
  bool drawing = false;  ///< the next drag draws the figure's points
  bool can_undo = false, can_redo = false;
  bool reduced_motion = false;  ///< no easing of hover and switches
  std::vector<StageLabel> labels;
  std::string notice;                       ///< a refusal or hint to show for a moment, may be empty
  const SurfaceQuality* quality = nullptr;  ///< of a surface that is not just lit
};

/// State of the panels alone (what is folded, the drawer, what is fading out); one struct, passed by reference.
struct PanelState {
  bool drawer_open = false;
  bool show_more = false;  ///< the display, sampling and motion rows

  float drawer_share = 0, more_share = 0, probe_share = 0, notice_share = 0;  ///< how far each has come into view
  float card_height = 0;                  ///< as measured in the last frame, CSS pixels
  std::optional<Probe> last_probe;        ///< stays while it fades
  std::string last_notice, shown_notice;  ///< in English, and as it is said
  KnotDrag knot, knot_v;                  ///< in the one strip, or that of u and that of v
  bool slider_held = false;               ///< a gesture is open
  bool list_open = false;                 ///< a list of choices, which Escape closes
  bool moving = false;                    ///< the last frame was not the last of a transition
  struct FingerScroll {
    std::string window;  ///< whose rows the finger is on; empty when on none
    float start = 0, scroll_at_start = 0;
    bool moving = false;
  } finger;
  std::vector<std::vector<float>> thumbnails;  ///< the little plots in the list of blending functions
};

struct PanelOutput {
  std::vector<scene::Command> commands;
  bool begin_gesture = false, end_gesture = false;  ///< a slider was taken, let go
  bool undo = false, redo = false, frame_all = false;
  std::vector<std::string> keys;  ///< buttons that do what a key does on the stage
  bool wants_frame = false;       ///< something in the interface is still moving
  bool takes_wheel = false;  ///< the card or an open list is longer than its place: a plain wheel over it scrolls it
  std::vector<Widget> widgets;
  std::vector<std::array<double, 4>> readouts;  ///< take no pointers, but the picture keeps clear of them
  std::vector<std::array<double, 4>> regions;   ///< cards and popups that take pointers, x y width height in CSS pixels

  /// As before a frame. The lists keep their memory, the widgets for the next ones' words.
  void clear() {
    commands.clear();
    keys.clear();
    readouts.clear();
    regions.clear();
    begin_gesture = end_gesture = undo = redo = frame_all = wants_frame = takes_wheel = false;
  }
};

/// Draws panel, clock, probe and notice with ImGui inside a running ImGui frame.
void draw_panels(PanelState& state, const PanelInput& input, PanelOutput& output);

}  // namespace knotwork::web
