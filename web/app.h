#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "knotwork/scene/history.h"
#include "knotwork/scene/later.h"
#include "knotwork/scene/surface_builder.h"
#include "web/composition.h"
#include "web/curve_tools.h"
#include "web/interaction.h"
#include "web/interface_style.h"
#include "web/panels.h"
#include "web/renderer.h"
#include "web/stage_grid.h"

namespace knotwork::web {

/// What stats() of the script interface tells.
struct AppStats {
  std::int64_t frames = 0;       ///< since start
  double evaluate_ms = 0;        ///< up to the last frame, since the one before: building surface, maps and tables
  double frame_ms = 0;           ///< of the last frame: all of the main thread's work
  int allocations = 0;           ///< of memory, in the last frame
  int interface_draw_calls = 0;  ///< of the last frame
};

/// The program behind the stage: holds the document, hands events on, and draws frames when something has changed.
/// Events change the document through commands only; `frame` brings geometry, picture and interface up to it.
class App {
 public:
  /// Opens the first chapter.
  App();

  /// A WebGL2 context has become current. Empty, or why it cannot be used.
  std::string attach_context();
  void lose_context();

  void set_font(int weight, std::vector<std::uint8_t> bytes);
  void resize(double css_width, double css_height, double pixel_ratio);
  void set_scheme(bool dark);
  void set_reduced_motion(bool reduced);
  /// The module's part that fits grids to the screen is here.
  void allow_fitted_grids();

  /// Draws a frame if one is needed; `now` in milliseconds. True when another one is wanted at once.
  bool frame(double now);
  bool wants_frame() const { return pending_frames_ > 0; }

  bool pointer(const PointerEvent& event);
  bool wheel(const WheelEvent& event);
  bool key(const KeyEvent& event);
  void focus(bool focused);
  const char* cursor() const;

  /// One command as one step of the history; a refusal is shown as a notice too.
  Status perform(const scene::Command& command);
  Status load(scene::Document document);
  Status open_chapter(std::string_view id);
  /// The page has many figures and one stage: each is a scene with a document and a history of its own. True: it is on
  /// the stage as it was left. False: it is new, with what is on the stage now, and the caller says what it shows.
  KNOTWORK_LATER bool enter_scene(const std::string& name);
  /// What is on the stage now is the scene's start: the camera takes all of it into view, and there is nothing to undo
  /// unless the scene has come back there, `again`.
  KNOTWORK_LATER void begin_scene(bool again);
  /// Points as text replace those on the stage; a refusal is shown as a notice too.
  KNOTWORK_LATER Status take_points(std::string_view text);
  /// Commands between an opened and a closed gesture are one step of the history.
  void gesture(bool open);
  bool undo();
  bool redo();
  void select(std::optional<HandleIndex> handle);

  const scene::Document& document() const { return document_; }
  /// What the scene on the stage began with.
  const scene::Document& start() const { return start_; }
  const scene::History& history() const { return history_; }
  /// Whether it is the blending surface that stands on the stage.
  bool shows_surface() const;
  /// The surface that the document means, without the rolling between two topologies. Precondition: shows_surface().
  BlendingSurface surface_at_rest() const;
  const std::vector<Handle>& handles();
  std::optional<HandleIndex> selected() const { return interaction_.selected; }
  const std::vector<Widget>& widgets() const { return panel_output_.widgets; }
  /// What the page's live region should say.
  const std::string& notice() const { return spoken_; }
  const AppStats& stats() const { return stats_; }
  RendererStats renderer_stats() const { return renderer_.stats(); }
  /// Grows whenever something that the page shows beside the stage has changed.
  double revision() const { return static_cast<double>(revision_); }

 private:
  /// The sheet on its way between two topologies.
  struct RollTransition {
    scene::Roll from{1, 1}, to{1, 1}, shown{1, 1};
    scene::ModelKind model = scene::ModelKind::sheet;  ///< one model does not roll into another
    scene::SplineDirection other_u, other_v;           ///< of a net, in the topology that it came from
    double start = 0;
    bool active = false;
  };
  using Insets = std::array<double, 4>;  ///< left, top, right, bottom, CSS pixels
  struct CameraTransition {
    scene::Camera from, to;
    Insets insets_from, insets_to;
    double start = 0, duration = 0;
  };
  /// What stands on the stage, and what it was made from. A blending surface is rebuilt by parts: edits and clock change
  /// the maps alone.
  struct Geometry {
    std::optional<Figure> figure;     ///< there is one from the first frame on
    std::optional<CurveTools> tools;  ///< of a curve, for `tools_of`; made when first asked for
    scene::Display tools_of;
    scene::Shape made_from;
    scene::Animation animation;
    scene::Roll roll{-1, -1};
    bool maps_uploaded = false, tables_uploaded = false, hues_uploaded = false;
    bool parted = false;  ///< the grid of the tables
    /// What a look into the surface has found for its shading; made anew when either changes.
    std::optional<SurfaceQuality> quality;
    SurfaceQuality awaited;                  ///< stands for it until then
    bool quality_stale = false;              ///< the surface has moved since
    bool curvature_uploaded = false;         ///< for the grid of the tables
    double looked_at = 0, looking_took = 0;  ///< milliseconds
  };

  void advance(double now);
  void advance_roll(double now);
  void update_geometry();
  void update_surface(const scene::BlendingSurfaceObject& object);
  KNOTWORK_LATER void update_net(const scene::BSplineSurfaceObject& object);
  void upload_blending(const BlendingFigure& figure, const scene::BlendingSurfaceObject& object);
  KNOTWORK_LATER void upload_model(const ModelSurfaceFigure& figure, const scene::ModelSurfaceObject& object);
  KNOTWORK_LATER void upload_net(const NetSurfaceFigure& figure, const scene::BSplineSurfaceObject& object);
  void forget_gesture();
  void after_travel(const scene::Camera& camera_before);
  void update_floor(double seconds);
  void upload();
  bool choose_grid(int samples_u, int samples_v);
  SampleGrid chosen_grid() const { return grid_.grid(*geometry_.figure, geometry_.parted); }
  bool looks_deeper() const;
  const SurfaceQuality* quality_shown();
  KNOTWORK_LAST void look_into_surface();
  void run_interface(double seconds);
  void draw();
  void apply_outcome(const Outcome& outcome);
  void changed();
  void request_frames(int count);
  void say(std::string notice);
  /// What a picture has to have room for, in model space.
  struct Extent {
    std::vector<glm::dvec3> points, handles;
  };
  void make_room_for(const Extent& next);
  void frame_all();
  Extent extent();
  Extent extent_at_rest() const;
  KNOTWORK_LAST const CurveTools& tools();
  void place_picture();
  void compose_for(const Extent& extent, double duration);
  void snap();
  View view() const;
  Viewport free_viewport() const;
  /// What an event at `position` looks at; handles near it know whether something hides them.
  Stage stage(glm::dvec2 position);
  std::optional<glm::dvec2> pointed() const;
  std::vector<StageLabel> stage_labels();
  const Picture& picture();
  bool over_interface(glm::dvec2 position) const;
  Obstacles obstacles() const { return {panel_output_.regions, panel_output_.readouts}; }

  scene::Document document_, start_;
  scene::History history_;
  struct Scene {
    scene::Document document, start;
    scene::History history;
    bool camera_is_ours;
  };
  std::map<std::string, Scene> left_scenes_;
  std::string scene_;  ///< the name of the one on the stage
  InteractionState interaction_;
  PanelState panel_state_;
  PanelOutput panel_output_;
  Renderer renderer_;
  Theme theme_;
  Viewport viewport_;
  InterfaceFonts fonts_;
  std::vector<std::uint8_t> regular_face_, bold_face_;
  bool fonts_stale_ = true;
  bool context_ready_ = false;
  bool reduced_motion_ = false;
  bool framed_once_ = false;  ///< the panel has been laid out, so that the picture could be placed

  Picture picture_;
  Geometry geometry_;
  StageGrid grid_;
  std::vector<Handle> handles_;
  RollTransition roll_;
  std::optional<CameraTransition> camera_transition_;
  Insets insets_{};             ///< the part of the stage that the picture is not centred in
  bool camera_is_ours_ = true;  ///< composed by the program; false once the reader has moved it
  bool recompose_ = false;
  bool compose_at_once_ = false;  ///< another figure has come: the camera does not travel to it
  bool drawer_was_open_ = false, fold_was_open_ = false, legend_was_there_ = false;
  Floor floor_;
  double floor_target_ = -1;

  View stage_view_;                                     ///< what the last event was measured in
  std::set<int> interface_pointers_;                    ///< pointers that went down on a panel
  std::optional<int> interface_leader_;                 ///< the first of them: ImGui's mouse
  bool over_before_ = false;                            ///< the hovering pointer was over a panel
  std::vector<float> maps_;                             ///< of the last frame; its memory is used again
  std::vector<std::array<double, 4>> words_and_rings_;  ///< what names keep clear of; likewise
  std::string notice_;                                  ///< shown on the stage for a moment
  std::string spoken_;                                  ///< for the page's live region: the last deed or notice
  double notice_until_ = 0;
  int pending_frames_ = 3;
  bool running_ = false;  ///< the last frame asked for this one
  double now_ = 0, last_frame_ = 0, last_zoom_ = -1e9;
  std::uint64_t revision_ = 1;
  AppStats stats_;
  double evaluating_ms_ = 0;  ///< spent on geometry since the last frame
};

}  // namespace knotwork::web
