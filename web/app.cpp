#include "web/app.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <glm/geometric.hpp>

#include "knotwork/mesh/blending_tables.h"
#include "knotwork/mesh/curvature_field.h"
#include "knotwork/mesh/net_tables.h"
#include "knotwork/mesh/surface_tables.h"
#include "knotwork/scene/chapters.h"
#include "knotwork/scene/curve_edits.h"
#include "knotwork/scene/palette.h"
#include "knotwork/scene/point_text.h"
#include "web/allocations.h"
#include "web/figure_picture.h"
#include "web/model_ornaments.h"
#include "web/net_ornaments.h"
#include "web/stage_ornaments.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

constexpr double roll_ms = 600, camera_ms = 350, notice_ms = 4200;
constexpr double usual_frame_ms = 1000.0 / 60;
constexpr double longest_step = 0.1;    // seconds of clock after a pause in drawing
constexpr double floor_seconds = 0.06;  // in which the floor covers 1 - 1/e of its way
constexpr int frames_after_event = 3;   // ImGui spreads a quick tap over this many frames
constexpr int rolling_samples = 192;    // while the static part changes in every frame
constexpr glm::dvec2 nowhere{-1e9, -1e9};
constexpr double handle_neighbourhood = 60;  // CSS pixels; farther handles cannot be meant
constexpr double zoom_pause_ms = 200;        // a wheel that has turned so lately may turn on
constexpr double phone_width = 520;          // CSS pixels; a narrower stage has a drawer

double milliseconds() {
  using namespace std::chrono;
  return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

std::vector<glm::dvec3> places_of(std::span<const Handle> handles) {
  std::vector<glm::dvec3> places;
  places.reserve(handles.size());
  for (const Handle& handle : handles) places.push_back(handle.position);
  return places;
}

bool same(const scene::Roll& a, const scene::Roll& b) { return a.u == b.u && a.v == b.v; }

/// Whether the tables that stand on the GPU serve both: they differ in edits only.
bool same_static_part(const scene::BlendingSurfaceObject& a, const scene::BlendingSurfaceObject& b) {
  return a.model == b.model && a.topology_u == b.topology_u && a.topology_v == b.topology_v &&
         a.locals_u == b.locals_u && a.locals_v == b.locals_v && a.patches == b.patches && a.blending == b.blending &&
         a.blending_parameter == b.blending_parameter && a.samples_u == b.samples_u && a.samples_v == b.samples_v;
}

}  // namespace

App::App() : theme_(make_theme(false)) {
  count_interface_allocations();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
  start_ = document_ = scene::chapters().front().start_document();
  snap();
}

// --- Life ----------------------------------------------------------------------------------------------------------

std::string App::attach_context() {
  if (ImGui::GetIO().BackendRendererUserData != nullptr) ImGui_ImplOpenGL3_Shutdown();
  std::string log = renderer_.prepare();
  if (!log.empty()) return log;
  if (!ImGui_ImplOpenGL3_Init("#version 300 es")) return "The interface could not be set up.";
  context_ready_ = true;
  fonts_stale_ = true;
  geometry_.maps_uploaded = geometry_.tables_uploaded = geometry_.hues_uploaded = false;
  request_frames(frames_after_event);
  return {};
}

void App::lose_context() {
  context_ready_ = false;
  renderer_.abandon();
}

void App::set_font(int weight, std::vector<std::uint8_t> bytes) {
  (weight >= 600 ? bold_face_ : regular_face_) = std::move(bytes);
  fonts_stale_ = true;
  request_frames(frames_after_event);
}

void App::resize(double css_width, double css_height, double pixel_ratio) {
  viewport_.width = std::max(css_width, 1.0);
  viewport_.height = std::max(css_height, 1.0);
  if (pixel_ratio != viewport_.pixel_ratio) fonts_stale_ = true;
  viewport_.pixel_ratio = pixel_ratio;
  recompose_ = true;
  request_frames(frames_after_event);
}

void App::set_scheme(bool dark) {
  theme_ = make_theme(dark);
  geometry_.hues_uploaded = false;
  request_frames(frames_after_event);
}

void App::set_reduced_motion(bool reduced) {
  reduced_motion_ = reduced;
  request_frames(1);
}

void App::request_frames(int count) { pending_frames_ = std::max(pending_frames_, count); }

// --- Document ------------------------------------------------------------------------------------------------------

void App::changed() {
  ++revision_;
  request_frames(2);
  const scene::Shape& shape = scene::stage_shape(document_);
  if (interaction_.selected && !has_handle(shape, *interaction_.selected)) interaction_.selected.reset();
  if (interaction_.hovered && !has_handle(shape, *interaction_.hovered)) interaction_.hovered.reset();
  interaction_.insertion.reset();
  if (shape.index() != geometry_.made_from.index()) interaction_.probe.reset();
  const auto* net = std::get_if<scene::BSplineSurfaceObject>(&shape);
  const auto* drawn = std::get_if<scene::BSplineSurfaceObject>(&geometry_.made_from);
  if (net && drawn) {
    if (net->u.topology != drawn->u.topology) roll_.other_u = drawn->u;
    if (net->v.topology != drawn->v.topology) roll_.other_v = drawn->v;
  }
  if (!shows_surface()) {
    // What is in the catalogues differs in size: another one is brought into view.
    if (is_other_model(shape, geometry_.made_from)) recompose_ = recompose_ || camera_is_ours_;
    return;
  }

  const scene::BlendingSurfaceObject& object = scene::blending_surface(document_);
  if (scene::model_kind(object.model) != roll_.model) {
    snap();
    recompose_ = recompose_ || camera_is_ours_;
  }
  // Only the sheet rolls. A fixed model has no shape on the way, least of all one that cannot close.
  if (scene::model_kind(object.model) != scene::ModelKind::sheet) roll_.from = roll_.shown = scene::rest_roll(object);
}

void App::say(std::string notice) {
  notice_ = spoken_ = std::move(notice);
  notice_until_ = now_ + notice_ms;
  ++revision_;
  request_frames(1);
}

Status App::perform(const scene::Command& command) {
  std::string also = scene::notice(document_, command);
  Status status = history_.perform(document_, command);
  if (!status) {
    say(status.error().message);
    return status;
  }
  if (scene::in_history(command)) spoken_ = scene::describe(command);
  if (!also.empty()) say(std::move(also));
  changed();
  return status;
}

Status App::load(scene::Document document) {
  Status status = perform(scene::LoadDocument{std::move(document)});
  if (status) {
    snap();
    camera_is_ours_ = false;  // the document says where it stands
  }
  return status;
}

Status App::take_points(std::string_view text) {
  if (!scene::is_made_from_list(scene::stage_shape(document_))) return perform(scene::SetPoints{});
  Result<std::vector<Eigen::Vector3d>> points = scene::parse_points(text);
  if (!points) {
    const Error& error = points.error();
    say(error.path.empty() ? error.message : "In " + error.path + ": " + error.message);
    return error;
  }
  Status status = perform(scene::SetPoints{std::move(points).value()});
  if (status && framed_once_) frame_all();  // they may be anywhere
  return status;
}

Status App::open_chapter(std::string_view id) {
  const scene::Chapter* chapter = scene::find_chapter(id);
  if (chapter == nullptr) return Error{"", "There is no chapter \"" + std::string(id) + "\"."};
  Status status = load(chapter->start_document());
  if (status && framed_once_) {
    camera_is_ours_ = recompose_ = true;
    compose_at_once_ = true;
  }
  return status;
}

bool App::enter_scene(const std::string& name) {
  if (name == scene_) return true;
  if (scene_.empty()) {  // what the stage starts with becomes the first scene, in whatever hand it is
    scene_ = name;
    return false;
  }
  history_.end_gesture();
  forget_gesture();
  left_scenes_[scene_] = {document_, std::move(start_), std::move(history_), camera_is_ours_};
  scene_ = name;
  start_ = document_;
  interaction_.drawing = false;
  interaction_.selected.reset();
  interaction_.probe.reset();
  if (interaction_.drag != InteractionState::Drag::none) interaction_.drag = InteractionState::Drag::rest;
  const auto found = left_scenes_.find(name);
  const bool known = found != left_scenes_.end();
  if (known) {
    document_ = std::move(found->second.document);
    start_ = std::move(found->second.start);
    camera_is_ours_ = found->second.camera_is_ours;
    snap();
    // The stage may have got another size meanwhile.
    recompose_ = compose_at_once_ = camera_is_ours_;
  }
  history_ = known ? std::move(found->second.history) : scene::History();
  if (known) left_scenes_.erase(found);
  geometry_.quality.reset();  // of the scene before
  changed();
  return known;
}

void App::begin_scene(bool again) {
  if (framed_once_) camera_is_ours_ = recompose_ = compose_at_once_ = true;
  if (!again) {
    start_ = document_;
    history_ = scene::History();
    notice_.clear();
    spoken_.clear();
  }
  changed();
}

/// The history has one gesture at a time. When something else ends it under a hand, what the hand goes on to do is
/// another step.
void App::forget_gesture() { interaction_.gesture_open = interaction_.nudging = false; }

void App::gesture(bool open) {
  forget_gesture();
  if (open) {
    history_.begin_gesture();
  } else {
    history_.end_gesture();
    changed();
  }
}

bool App::undo() {
  const scene::Camera camera = document_.camera;
  forget_gesture();
  std::string spoken = "Undone: " + history_.undo_label();
  if (!history_.undo(document_)) return false;
  spoken_ = std::move(spoken);
  after_travel(camera);
  return true;
}

/// Back or forth in the history. Where that has moved the camera, a whole document has come back: nothing is eased.
void App::after_travel(const scene::Camera& camera_before) {
  if (!(document_.camera == camera_before)) {
    snap();
    camera_is_ours_ = false;
  }
  changed();
}

bool App::redo() {
  const scene::Camera camera = document_.camera;
  forget_gesture();
  std::string spoken = "Redone: " + history_.redo_label();
  if (!history_.redo(document_)) return false;
  spoken_ = std::move(spoken);
  after_travel(camera);
  return true;
}

void App::select(std::optional<HandleIndex> handle) {
  apply_outcome(web::select(interaction_, stage(nowhere), handle));
  changed();
}

/// No transition: what is shown is what the document says.
void App::snap() {
  camera_transition_.reset();
  roll_.active = false;
  if (!rolls(scene::stage_shape(document_))) return;
  roll_.from = roll_.to = roll_.shown = roll_at_rest(scene::stage_shape(document_));
  if (!shows_surface()) return;
  roll_.model = scene::model_kind(scene::blending_surface(document_).model);
}

bool App::shows_surface() const {
  return std::holds_alternative<scene::BlendingSurfaceObject>(scene::stage_shape(document_));
}

BlendingSurface App::surface_at_rest() const {
  return scene::build_surface(scene::blending_surface(document_), document_.animation);
}

// --- Geometry ------------------------------------------------------------------------------------------------------

void App::update_geometry() {
  const scene::Shape& shape = scene::stage_shape(document_);
  const double start = milliseconds();
  if (const auto* object = std::get_if<scene::BlendingSurfaceObject>(&shape)) {
    update_surface(*object);
  } else if (const auto* net = std::get_if<scene::BSplineSurfaceObject>(&shape)) {
    update_net(*net);
  } else {
    const bool same_clock = !moves(shape) || document_.animation == geometry_.animation;
    if (geometry_.figure && shape == geometry_.made_from && same_clock) return;
    geometry_.tables_uploaded = geometry_.maps_uploaded = geometry_.hues_uploaded = false;
    floor_.half_size = 0;
    update_figure(geometry_.figure, shape, document_.animation);
    geometry_.made_from = shape;
    geometry_.animation = document_.animation;
    geometry_.tools.reset();
    handles_.clear();
  }
  evaluating_ms_ += milliseconds() - start;
}

void App::update_surface(const scene::BlendingSurfaceObject& object) {
  auto* shown = geometry_.figure ? std::get_if<BlendingFigure>(&*geometry_.figure) : nullptr;
  const auto* made_from = std::get_if<scene::BlendingSurfaceObject>(&geometry_.made_from);
  const bool same_shape =
      shown && made_from && same(roll_.shown, geometry_.roll) && same_static_part(object, *made_from);
  const bool same_object = same_shape && object.edits == made_from->edits;
  if (same_object && document_.animation == geometry_.animation) return;
  if (same_shape) {
    scene::update_locals(shown->surface, object, document_.animation, roll_.shown, shown->axes);
    shown->net.reset();
  } else {
    geometry_.tools.reset();
    geometry_.figure = BlendingFigure(scene::build_surface(object, document_.animation, roll_.shown));
    geometry_.roll = roll_.shown;
    geometry_.tables_uploaded = geometry_.hues_uploaded = false;
    floor_.half_size = 0;  // another shape needs another floor, even while it moves
  }
  if (!same_object) geometry_.made_from = object;  // a frame of the animation copies no edits
  geometry_.animation = document_.animation;
  geometry_.maps_uploaded = false;
  handles_.clear();
}

void App::update_net(const scene::BSplineSurfaceObject& object) {
  auto* shown = geometry_.figure ? std::get_if<NetSurfaceFigure>(&*geometry_.figure) : nullptr;
  const auto* made_from = std::get_if<scene::BSplineSurfaceObject>(&geometry_.made_from);
  const bool same_roll = shown && made_from && same(roll_.shown, geometry_.roll);
  if (same_roll && object == *made_from) return;
  const bool same_knots = same_roll && object.u == made_from->u && object.v == made_from->v &&
                          object.rows() == made_from->rows() && object.columns() == made_from->columns();
  if (same_knots) {
    shown->shown.move(object, roll_.other_u, roll_.other_v, roll_.shown);
    shown->net.reset();
  } else {
    geometry_.tools.reset();
    geometry_.figure = NetSurfaceFigure{scene::NetFigure(object, roll_.other_u, roll_.other_v, roll_.shown), {}};
    geometry_.hues_uploaded = false;
    floor_.half_size = 0;
  }
  const bool same_grid =
      same_knots && object.samples_u == made_from->samples_u && object.samples_v == made_from->samples_v;
  if (!same_grid) geometry_.tables_uploaded = false;
  geometry_.maps_uploaded = false;
  geometry_.roll = roll_.shown;
  geometry_.made_from = object;
  handles_.clear();
}

void App::upload() {
  const double start = milliseconds();
  const scene::Display& display = document_.display;
  // What jumps at knot lines is what is looked for. Sheets do not go with that grid.
  const bool parted = display.shading != scene::Shading::lit && !display.local_patches;
  if (parted != geometry_.parted) geometry_.tables_uploaded = false;
  geometry_.parted = parted;
  if (!geometry_.maps_uploaded) geometry_.quality_stale = true;
  if (!looks_deeper()) geometry_.quality.reset();
  if (const auto* blending = std::get_if<BlendingFigure>(&*geometry_.figure))
    upload_blending(*blending, *std::get_if<scene::BlendingSurfaceObject>(&geometry_.made_from));
  if (const auto* net = std::get_if<NetSurfaceFigure>(&*geometry_.figure))
    upload_net(*net, *std::get_if<scene::BSplineSurfaceObject>(&geometry_.made_from));
  if (const auto* model = std::get_if<ModelSurfaceFigure>(&*geometry_.figure))
    upload_model(*model, *std::get_if<scene::ModelSurfaceObject>(&geometry_.made_from));
  if (looks_deeper()) look_into_surface();
  evaluating_ms_ += milliseconds() - start;
}

/// Whether it is a surface that is not just lit.
bool App::looks_deeper() const {
  return document_.display.shading != scene::Shading::lit && surface_of(*geometry_.figure).has_value();
}

/// Its legend has its place from the first frame on: the picture is composed beside it.
const SurfaceQuality* App::quality_shown() {
  if (!looks_deeper()) return nullptr;
  if (geometry_.quality && geometry_.quality->shading == document_.display.shading) return &*geometry_.quality;
  geometry_.awaited.shading = document_.display.shading;
  return &geometry_.awaited;
}

/// Curvature for the colours, and how smooth the surface is at its knot lines. While something moves, looking takes a
/// fifth of the time at most, but for the colours of a new grid: on a fine one they follow a little later.
void App::look_into_surface() {
  const scene::Shading shading = document_.display.shading;
  const double start = milliseconds();
  const bool busy = document_.animation.playing || roll_.active || interaction_.drag != InteractionState::Drag::none;
  const bool due = !busy || start - geometry_.looked_at >= 4 * geometry_.looking_took;
  if (geometry_.quality && geometry_.quality->shading == shading && geometry_.curvature_uploaded) {
    if (!geometry_.quality_stale) return;
    if (!due) {
      request_frames(1);
      return;
    }
  }
  const KnottedSurface surface = *surface_of(*geometry_.figure);
  SurfaceQuality quality{.shading = shading, .known = true};
  if (shading == scene::Shading::gaussian || shading == scene::Shading::mean) {
    const auto kind = shading == scene::Shading::mean ? CurvatureKind::mean : CurvatureKind::gaussian;
    const CurvatureField field = curvature_field(surface, chosen_grid(), kind);
    renderer_.upload_curvature(field.values);
    quality.scale = field.scale;
  }
  geometry_.curvature_uploaded = true;
  if (geometry_.quality && !due) {
    // New tables needed new colours at once; the lines can wait.
    geometry_.quality->scale = quality.scale;
    geometry_.quality->shading = shading;
    request_frames(1);
    return;
  }
  const auto* blending = std::get_if<BlendingFigure>(&*geometry_.figure);
  glm::dvec3 low(std::numeric_limits<double>::max()), high(-std::numeric_limits<double>::max());
  for (const glm::dvec3& point : outline(surface)) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  const JointSeams seams = blending ? untwisted_seams(blending->surface) : JointSeams();
  // A model is one formula, not pieces that meet.
  if (!std::holds_alternative<ModelSurfaceFigure>(*geometry_.figure)) {
    find_fault(quality, surface_joints(surface, 4, seams), glm::distance(low, high));
    quality.words = fault_text(quality);
  }
  geometry_.quality = std::move(quality);
  geometry_.quality_stale = false;
  geometry_.looked_at = milliseconds();
  geometry_.looking_took = geometry_.looked_at - start;
  request_frames(1);  // the numbers stand in the next picture
}

/// Whether tables have to be made for the surface on the stage, of a grid that is chosen then.
bool App::choose_grid(int samples_u, int samples_v) {
  const bool zooms = now_ - last_zoom_ < zoom_pause_ms;
  if (zooms) request_frames(1);
  const bool busy = document_.animation.playing || interaction_.drag != InteractionState::Drag::none ||
                    camera_transition_.has_value() || zooms;
  const bool chosen = grid_.choose({.figure = *geometry_.figure,
                                    .samples_u = samples_u,
                                    .samples_v = samples_v,
                                    .fitted = document_.display.adaptive && !roll_.active,
                                    .view = view(),
                                    .other_grid = !geometry_.tables_uploaded,
                                    .changed = !geometry_.maps_uploaded,
                                    .busy = busy,
                                    .now = now_});
  if (grid_.wants_another_look()) request_frames(1);
  geometry_.tables_uploaded = true;
  if (chosen) geometry_.curvature_uploaded = false;
  return chosen;
}

void App::allow_fitted_grids() {
  grid_.allow_fitting();
  request_frames(1);
}

void App::upload_net(const NetSurfaceFigure& figure, const scene::BSplineSurfaceObject& object) {
  const BSplineSurface& surface = figure.shown.surface;
  const int rows = surface.knots_u().count(), columns = surface.knots_v().count();
  if (choose_grid(object.samples_u, object.samples_v)) renderer_.upload(net_tables(surface, chosen_grid()));
  if (!geometry_.maps_uploaded) renderer_.upload_net(point_table(surface), rows, columns);
  if (!geometry_.hues_uploaded) renderer_.upload_hues(net_hues(figure.shown, object, theme_.dark), rows, columns);
  geometry_.maps_uploaded = geometry_.hues_uploaded = true;
}

void App::upload_model(const ModelSurfaceFigure& figure, const scene::ModelSurfaceObject& object) {
  if (choose_grid(object.samples_u, object.samples_v))
    renderer_.upload(surface_tables(knotted_surface(figure.shown), chosen_grid()));
  if (!geometry_.hues_uploaded) renderer_.upload_hues(std::array{model_hue(theme_)}, 1, 1);
  geometry_.maps_uploaded = geometry_.hues_uploaded = true;
}

void App::upload_blending(const BlendingFigure& figure, const scene::BlendingSurfaceObject& object) {
  const BlendingSurface& surface = figure.surface;
  const MapCounts counts = map_counts(surface);
  const int most = roll_.active ? rolling_samples : scene::max_samples;
  if (choose_grid(std::min(object.samples_u, most), std::min(object.samples_v, most)))
    renderer_.upload(blending_tables(surface, chosen_grid()));
  if (!geometry_.maps_uploaded) {
    map_table(surface, maps_);
    renderer_.upload_maps(maps_, counts.u, counts.v);
    geometry_.maps_uploaded = true;
  }
  if (!geometry_.hues_uploaded) {
    std::vector<glm::vec3> hues;
    hues.reserve(static_cast<std::size_t>(counts.u) * static_cast<std::size_t>(counts.v));
    for (int i = 0; i < counts.u; ++i) {
      for (int j = 0; j < counts.v; ++j) {  // the ghost past the last local, while rolling, is local 0 again
        const auto [own_i, own_j] = surface.wrapped(i, j);
        const scene::PatchIndex patch{own_i % object.locals_u, own_j % object.locals_v};
        hues.push_back(oklab(scene::patch_hue(scene::patch_hue_index(object, patch), theme_.dark)));
      }
    }
    renderer_.upload_hues(hues, counts.u, counts.v);
    geometry_.hues_uploaded = true;
  }
}

/// The floor lies a little under the lowest point; it does not bob with a playing animation or a held patch.
void App::update_floor(double seconds) {
  if (!surface_of(*geometry_.figure)) return;
  const bool steady = !document_.animation.playing && interaction_.drag == InteractionState::Drag::none;
  if (steady || floor_.half_size <= 0) {
    glm::dvec3 low(std::numeric_limits<double>::max()), high(-std::numeric_limits<double>::max());
    for (const glm::dvec3& point : outline(*surface_of(*geometry_.figure))) {
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
    const double size = glm::distance(low, high);
    floor_.x = 0.5 * (low.x + high.x);
    floor_.y = 0.5 * (low.y + high.y);
    floor_.half_size = 1.05 * size;
    floor_target_ = low.z - 0.12 * size;
  }
  const double gap = floor_target_ - floor_.height;
  if (std::abs(gap) < 1e-3 * floor_.half_size || reduced_motion_ || !framed_once_) {
    floor_.height = floor_target_;
  } else {
    floor_.height += gap * -std::expm1(-seconds / floor_seconds);
    request_frames(1);
  }
}

const std::vector<Handle>& App::handles() {
  update_geometry();  // a script may ask between a command and its frame
  const View now = view();
  if (handles_.empty()) take_handles(*geometry_.figure, geometry_.made_from, handles_);
  for (Handle& handle : handles_) handle.screen = now.project(handle.position);
  return handles_;
}

// --- Time ----------------------------------------------------------------------------------------------------------

void App::advance_roll(double now) {
  const scene::Shape& shape = scene::stage_shape(document_);
  if (!rolls(shape)) return;
  const scene::Roll rest = roll_at_rest(shape);
  if (!same(rest, roll_.to)) {
    roll_.from = roll_.shown;
    roll_.to = rest;
    roll_.start = now;
    roll_.active = !reduced_motion_ && !same(roll_.from, rest);
    if (!roll_.active) roll_.shown = rest;

    if (interaction_.drag == InteractionState::Drag::none) make_room_for(extent_at_rest());
  }
  if (!roll_.active) return;
  const double share = (now - roll_.start) / roll_ms;
  const double eased = ease(share);
  roll_.shown = {std::lerp(roll_.from.u, roll_.to.u, eased), std::lerp(roll_.from.v, roll_.to.v, eased)};
  if (share >= 1) {
    roll_.active = false;
    roll_.shown = roll_.to;
    geometry_.tables_uploaded = false;  // they may still be as coarse as while rolling
  }
  request_frames(2);
}

void App::advance(double now) {
  const double seconds = std::clamp((now - last_frame_) / 1000, 0.0, longest_step);
  if (document_.animation.playing) {
    // Not a step of the history: the clock runs by itself. It cannot fail.
    (void)apply(document_, scene::AdvanceClock{seconds});
    ++revision_;
    request_frames(1);
  }
  advance_roll(now);
  if (camera_transition_) {
    const CameraTransition& move = *camera_transition_;
    const double share = move.duration > 0 ? (now - move.start) / move.duration : 1;
    (void)apply(document_, scene::SetCamera{share >= 1 ? move.to : between(move.from, move.to, share)});
    for (std::size_t k = 0; k < insets_.size(); ++k)
      insets_[k] = std::lerp(move.insets_from[k], move.insets_to[k], ease(share));
    if (share >= 1) camera_transition_.reset();
    request_frames(1);
  }
  if (!notice_.empty() && now > notice_until_) {
    notice_.clear();
    ++revision_;
  }
  if (!notice_.empty()) request_frames(1);
}

/// The largest picture of the points that panel and clock leave room for, reached over `duration` milliseconds.
void App::compose_for(const Extent& extent, double duration) {
  const Composition composition = compose(document_.camera, {extent.points, extent.handles}, viewport_, obstacles());
  const Viewport& to = composition.viewport;
  camera_transition_ = CameraTransition{.from = document_.camera,
                                        .to = composition.camera,
                                        .insets_from = insets_,
                                        .insets_to = {to.inset_left, to.inset_top, to.inset_right, to.inset_bottom},
                                        .start = now_,
                                        .duration = reduced_motion_ ? 0 : duration};
  if (camera_transition_->duration <= 0) {
    (void)apply(document_, scene::SetCamera{camera_transition_->to});
    insets_ = camera_transition_->insets_to;
    camera_transition_.reset();
  }
  camera_is_ours_ = true;
  request_frames(2);
}

/// Before the surface rolls into another shape. A reader's own view is kept as long as it holds that shape as well as it
/// holds the present one.
void App::make_room_for(const Extent& next) {
  const View now = view();
  const auto in_view = [&now](const std::vector<glm::dvec3>& points) {
    return std::all_of(points.begin(), points.end(), [&now](const glm::dvec3& point) {
      const std::optional<glm::dvec3> screen = now.project(point);
      return screen && screen->x >= 0 && screen->y >= 0 && screen->x <= now.viewport.width &&
             screen->y <= now.viewport.height;
    });
  };
  const bool ours = camera_is_ours_;
  const bool shown = geometry_.figure && surface_of(*geometry_.figure);
  if (!ours && (in_view(next.points) || !shown || !in_view(outline(*geometry_.figure)))) return;
  compose_for(next, roll_ms);
  camera_is_ours_ = ours;
}

void App::frame_all() {
  update_geometry();
  compose_for(extent(), camera_ms);
}

/// What the picture of the figure has to have room for. A figure without tools does not call for them: what makes them is
/// in the last part of the module, and a call would wait for it.
App::Extent App::extent() {
  std::vector<glm::dvec3> held;
  if (document_.display.handles) held = places_of(handles());
  Extent extent{outline(*geometry_.figure), std::move(held)};
  for (const Eigen::Vector3d& ring : document_.display.rings) extent.points.push_back(to_glm(ring));
  if (!wants_tools(document_.display)) return extent;
  const std::vector<glm::dvec3>& tips = tools().tips;
  extent.points.insert(extent.points.end(), tips.begin(), tips.end());
  return extent;
}

/// Of a surface that rolls, where it comes to rest.
App::Extent App::extent_at_rest() const {
  const scene::Shape& shape = scene::stage_shape(document_);
  const Figure figure = make_figure(shape, document_.animation);
  std::vector<Handle> at_rest;
  if (document_.display.handles) take_handles(figure, shape, at_rest);
  return {outline(figure), places_of(at_rest)};
}

const CurveTools& App::tools() {
  if (!geometry_.tools || !(geometry_.tools_of == document_.display)) {
    geometry_.tools = curve_tools(*geometry_.figure, document_.display);
    geometry_.tools_of = document_.display;
  }
  return *geometry_.tools;
}

// --- Frame ---------------------------------------------------------------------------------------------------------

bool App::frame(double now) {
  const bool has_letters = !regular_face_.empty() && !bold_face_.empty();
  if (!context_ready_ || !has_letters || pending_frames_ <= 0) return running_ = false;
  const double start = milliseconds();
  const std::int64_t allocations_before = allocation_count();
  if (!running_) {
    last_frame_ = now - usual_frame_ms;  // idle until now: no leap of the clock
    // Events read the time of the last frame: what they have begun since begins now.
    if (camera_transition_) camera_transition_->start += now - now_;
    notice_until_ += now - now_;
  }
  --pending_frames_;
  now_ = now;
  const double seconds = std::clamp((now - last_frame_) / 1000, 1e-4, longest_step);

  advance(now);
  update_geometry();
  // The stage's net costs as much as a mesh: only a held patch is worth it in every frame.
  if (document_.animation.playing && interaction_.gesture_open) apply_outcome(web::hold(interaction_, stage(nowhere)));
  run_interface(seconds);
  advance_roll(now);  // what the interface has just changed is in this very picture
  update_geometry();
  update_floor(seconds);
  upload();
  draw();

  last_frame_ = now;
  ++stats_.frames;
  stats_.frame_ms = milliseconds() - start;
  stats_.allocations = static_cast<int>(allocation_count() - allocations_before);
  stats_.evaluate_ms = std::exchange(evaluating_ms_, 0);
  return running_ = wants_frame();
}

void App::run_interface(double seconds) {
  ImGuiIO& io = ImGui::GetIO();
  if (fonts_stale_) {
    ImGui_ImplOpenGL3_DestroyDeviceObjects();
    fonts_ = load_interface_fonts(regular_face_, bold_face_, viewport_.pixel_ratio);
    fonts_stale_ = false;
  }
  io.DisplaySize = {static_cast<float>(viewport_.width), static_cast<float>(viewport_.height)};
  io.DisplayFramebufferScale = {static_cast<float>(viewport_.pixel_ratio), static_cast<float>(viewport_.pixel_ratio)};
  io.DeltaTime = static_cast<float>(seconds);
  apply_interface_style(theme_);
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  draw_panels(panel_state_,
              {.document = document_,
               .figure = *geometry_.figure,
               .theme = theme_,
               .viewport = viewport_,
               .phone = viewport_.width < phone_width,
               .pointed = pointed(),
               .selected = interaction_.selected,
               .drawing = interaction_.drawing,
               .can_undo = history_.can_undo(),
               .can_redo = history_.can_redo(),
               .reduced_motion = reduced_motion_,
               .labels = stage_labels(),
               .notice = notice_,
               .quality = quality_shown()},
              panel_output_);
  ImGui::Render();

  if (panel_output_.begin_gesture) history_.begin_gesture();
  for (const scene::Command& command : panel_output_.commands) (void)perform(command);
  if (panel_output_.end_gesture) history_.end_gesture();
  if (panel_output_.undo) undo();
  if (panel_output_.redo) redo();
  for (const std::string& name : panel_output_.keys)
    apply_outcome(web::key(interaction_, stage(nowhere), {true, name, {}}));
  if (panel_output_.frame_all) frame_all();
  if (panel_output_.wants_frame) request_frames(2);
  const bool legend = looks_deeper();
  if (panel_state_.drawer_open != drawer_was_open_ || panel_state_.show_more != fold_was_open_ ||
      legend != legend_was_there_) {
    drawer_was_open_ = panel_state_.drawer_open;
    fold_was_open_ = panel_state_.show_more;
    legend_was_there_ = legend;
    recompose_ = true;
  }
  if (recompose_ && !panel_output_.wants_frame) place_picture();  // the panel stands where it will stay
}

/// The stage or what covers it has changed. A camera that the reader has moved stays where it is.
void App::place_picture() {
  recompose_ = false;
  const scene::Camera camera = document_.camera;
  const bool ours = camera_is_ours_;
  // A surface that rolls gets the room that it will need.
  compose_for(roll_.active ? extent_at_rest() : extent(), framed_once_ && ours && !compose_at_once_ ? camera_ms : 0);
  framed_once_ = true;
  compose_at_once_ = false;
  if (ours) return;
  (void)apply(document_, scene::SetCamera{camera});
  camera_is_ours_ = false;
}

void App::draw() {
  renderer_.draw(picture());
  const ImDrawData* interface = ImGui::GetDrawData();
  stats_.interface_draw_calls = 0;
  for (int k = 0; k < interface->CmdListsCount; ++k)
    stats_.interface_draw_calls += interface->CmdLists[k]->CmdBuffer.Size;
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

Viewport App::free_viewport() const {
  Viewport viewport = viewport_;
  viewport.inset_left = insets_[0];
  viewport.inset_top = insets_[1];
  viewport.inset_right = insets_[2];
  viewport.inset_bottom = insets_[3];
  return viewport;
}

View App::view() const { return make_view(document_.camera, free_viewport()); }

std::vector<StageLabel> App::stage_labels() {
  std::vector<StageLabel> labels;
  const View now = view();
  if (shows_names(*geometry_.figure, document_.display)) {
    words_and_rings_ = panel_output_.readouts;
    for (const Eigen::Vector3d& ring : document_.display.rings)
      if (const std::optional<glm::dvec3> at = now.project(to_glm(ring)))
        words_and_rings_.push_back({at->x - ring_radius, at->y - ring_radius, 2.0 * ring_radius, 2.0 * ring_radius});
    labels = labels_of(*geometry_.figure, handles(), now, theme_, {panel_output_.regions, words_and_rings_});
  }
  if (wants_tools(document_.display))
    add_tool_labels(labels, *geometry_.figure, document_.display, tools(), now, theme_);
  return labels;
}

/// Nothing while the sheet rolls: its parameters are not those of the surface that it becomes.
std::optional<glm::dvec2> App::pointed() const { return roll_.active ? std::nullopt : interaction_.probe; }

/// Into the last picture's memory.
const Picture& App::picture() {
  Picture& picture = picture_;
  picture.clear();
  picture.view = view();
  picture.target = to_glm(document_.camera.target);
  picture.theme = theme_;
  picture.display = document_.display;
  picture.floor = floor_;
  if (geometry_.quality) picture.curvature_scale = geometry_.quality->scale;
  add_to_picture(picture, *geometry_.figure, {document_, interaction_, handles(), roll_.active});
  if (wants_tools(document_.display)) add_tools(picture, *geometry_.figure, tools());
  if (!document_.display.rings.empty()) add_rings(picture);
  return picture;
}

// --- Events --------------------------------------------------------------------------------------------------------

Stage App::stage(glm::dvec2 position) {
  handles();
  stage_view_ = view();
  Stage stage{document_, *geometry_.figure, geometry_.made_from, stage_view_, handles_};
  if (!surface_of(stage.figure)) return stage;                          // a curve hides nothing
  if (interaction_.drag != InteractionState::Drag::none) return stage;  // nothing is looked for while a hand is busy
  for (Handle& handle : handles_) {
    if (!handle.screen || glm::distance(glm::dvec2(*handle.screen), position) > handle_neighbourhood) continue;
    const scene::Ray ray = stage_view_.ray(glm::dvec2(*handle.screen));
    const std::optional<scene::SurfaceHit> hit = stage.pick(ray);
    const double depth = glm::distance(handle.position, {ray.origin.x(), ray.origin.y(), ray.origin.z()});
    handle.hidden = hit && hit->distance < depth - 8 * stage_view_.pixel_size(handle.position);
  }
  return stage;
}

void App::apply_outcome(const Outcome& outcome) {
  if (outcome.cancel_gesture) {
    history_.cancel_gesture(document_);
    changed();
  }
  if (outcome.begin_gesture) history_.begin_gesture();
  for (const scene::Command& command : outcome.commands) {
    if (std::holds_alternative<scene::SetCamera>(command)) {
      camera_transition_.reset();
      camera_is_ours_ = false;
    }
    (void)perform(command);
  }
  if (outcome.end_gesture) {
    history_.end_gesture();
    ++revision_;
  }
  if (outcome.undo) undo();
  if (outcome.redo) redo();
  if (outcome.toggle_play) (void)perform(scene::SetParameter{"animation.playing", !document_.animation.playing});
  if (outcome.frame_all) frame_all();
  if (!outcome.notice.empty()) {
    spoken_ = outcome.notice;
    ++revision_;
  }
  if (!outcome.commands.empty() || outcome.cancel_gesture) update_geometry();
  if (outcome.redraw || !outcome.commands.empty()) request_frames(1);
}

bool App::over_interface(glm::dvec2 position) const {
  return std::any_of(panel_output_.regions.begin(), panel_output_.regions.end(), [&](const auto& rect) {
    return position.x >= rect[0] && position.y >= rect[1] && position.x < rect[0] + rect[2] &&
           position.y < rect[1] + rect[3];
  });
}

bool App::pointer(const PointerEvent& event) {
  if (!std::isfinite(event.position.x) || !std::isfinite(event.position.y)) {
    apply_outcome(web::pointer(interaction_, stage(nowhere), event));  // at most it lets go of a pointer
    return false;
  }
  ImGuiIO& io = ImGui::GetIO();
  const bool touch = event.device == PointerDevice::touch;
  const bool over = over_interface(event.position);
  bool interface_has_it = interface_pointers_.contains(event.id);
  const bool nothing_held = interaction_.drag == InteractionState::Drag::none && interaction_.pointers.empty();

  io.AddMouseSourceEvent(touch                                ? ImGuiMouseSource_TouchScreen
                         : event.device == PointerDevice::pen ? ImGuiMouseSource_Pen
                                                              : ImGuiMouseSource_Mouse);
  if (event.type == PointerType::down && over && nothing_held) {
    interface_pointers_.insert(event.id);
    interface_has_it = true;
    if (!interface_leader_) interface_leader_ = event.id;
  }
  // ImGui has one mouse: it follows the first pointer that took hold of a panel, else the hovering one, never a second
  // finger.
  const bool leads = interface_leader_ == event.id;
  const bool mouse_is_free = leads || !interface_leader_;
  const bool mouse_for_interface =
      leads || (mouse_is_free && nothing_held && (!touch || event.type == PointerType::down));
  if (mouse_for_interface && event.type != PointerType::leave)
    io.AddMousePosEvent(static_cast<float>(event.position.x), static_cast<float>(event.position.y));
  if (event.type == PointerType::leave && !interface_has_it) io.AddMousePosEvent(-FLT_MAX, -FLT_MAX);
  if (event.type == PointerType::down && event.button <= 0 && mouse_for_interface) io.AddMouseButtonEvent(0, true);
  if (mouse_is_free && (event.type == PointerType::up || event.type == PointerType::cancel)) {
    if (event.type == PointerType::cancel) io.AddMousePosEvent(-FLT_MAX, -FLT_MAX);  // let go, but not a click
    io.AddMouseButtonEvent(0, false);
    if (touch) io.AddMousePosEvent(-FLT_MAX, -FLT_MAX);
  }

  bool used = interface_has_it;
  if (!interface_has_it) {
    PointerEvent passed = event;
    if (over && nothing_held && event.type == PointerType::move) passed.type = PointerType::leave;
    const Outcome outcome = web::pointer(interaction_, stage(event.position), passed);
    apply_outcome(outcome);
    used = outcome.used;
  }
  if (event.type == PointerType::up || event.type == PointerType::cancel) {
    interface_pointers_.erase(event.id);
    if (leads) interface_leader_.reset();
  }

  const bool interface_cares = over || over_before_ || interface_has_it || event.type != PointerType::move;
  over_before_ = over;
  if (interface_cares) request_frames(frames_after_event);
  return used;
}

bool App::wheel(const WheelEvent& event) {
  if (over_interface(event.position)) {
    const bool zooms = event.modifiers.control || event.modifiers.meta;
    if (!panel_output_.takes_wheel) return zooms;  // a plain wheel belongs to the page
    ImGuiIO& io = ImGui::GetIO();
    io.AddMousePosEvent(static_cast<float>(event.position.x), static_cast<float>(event.position.y));
    io.AddMouseWheelEvent(0, static_cast<float>(-event.delta.y / 100));
    request_frames(frames_after_event);
    return true;
  }
  const Outcome outcome = web::wheel(interaction_, stage(event.position), event);
  if (outcome.used) last_zoom_ = now_;
  apply_outcome(outcome);
  return outcome.used;
}

bool App::key(const KeyEvent& event) {
  // The interface's only key: Escape closes an open list, and does nothing else then.
  if (event.key == "Escape") {
    ImGui::GetIO().AddKeyEvent(ImGuiKey_Escape, event.down);
    request_frames(frames_after_event);
    if (panel_state_.list_open) return true;
  }
  const Outcome outcome = web::key(interaction_, stage(nowhere), event);
  apply_outcome(outcome);
  return outcome.used;
}

void App::focus(bool focused) {
  ImGui::GetIO().AddFocusEvent(focused);
  if (!focused) apply_outcome(web::blur(interaction_));
  request_frames(frames_after_event);
}

const char* App::cursor() const { return over_before_ ? "default" : web::cursor(interaction_); }

}  // namespace knotwork::web
