#include "web/subdivision_panel.h"

#include <algorithm>
#include <array>

#include "knotwork/scene/subdivision_edits.h"
#include "web/log_plot.h"

namespace knotwork::web {
namespace {

namespace walk_words {
constexpr std::string_view draw = "Draw the polygon by hand", add = "Add a point after this one",
                           remove = "Delete this point", drawing = "Draw: press and drag", back = "A step back",
                           on = "A step on", walk = "Walk the steps", stop = "Stop",
                           exact = "Degree 1: the polygon is its own limit.";
}  // namespace walk_words

const scene::SubdivisionCurveObject& walked(const Frame& frame) {
  return *std::get_if<scene::SubdivisionCurveObject>(&frame.shape());
}

bool point_selected(const Frame& frame, const scene::SubdivisionFigure& figure) {
  const std::optional<HandleIndex>& selected = frame.input.selected;
  return selected && *selected != parameter_handle && selected->first >= 0 &&
         static_cast<std::size_t>(selected->first) < figure.points.size();
}

/// What the present step is.
Sentence step_text(const scene::SubdivisionCurveObject& object, const scene::SubdivisionFigure& figure) {
  const int level = figure.level;
  if (figure.pass == 0) return say("level {}", level);
  if (figure.pass == 1) return say("level {} to {}: split", level, level + 1);
  return say("level {} to {}: average {} of {}", level, level + 1, figure.pass - 1, object.degree);
}

float buttons_height(const Frame& frame) { return frame.ui.touch ? 40.0F : 34.0F; }

void set_number(Frame& frame, const char* id, int value) {
  frame.output.commands.emplace_back(scene::SetParameter{id, static_cast<double>(value)});
}

void draw_walk(Frame& frame, const Rect& row, const scene::SubdivisionFigure& figure) {
  const scene::SubdivisionCurveObject& object = walked(frame);
  const bool walks = frame.input.document.animation.playing;
  const float size = row.height;
  float x = row.x - 8;
  const auto place = [&] { return Rect{std::exchange(x, x + size), row.y, size, size}; };
  const bool back = object.step > 0 || object.fraction > 0, on = object.step < scene::step_count(object);
  if (icon_button(frame.ui, "step back", place(), Icon::back, back, say(walk_words::back)))
    set_number(frame, "subdivision.step", object.fraction > 0 ? object.step : object.step - 1);
  if (icon_button(frame.ui, "step on", place(), Icon::onwards, on, say(walk_words::on)))
    set_number(frame, "subdivision.step", object.step + 1);
  if (icon_button(frame.ui, "walk", place(), walks ? Icon::pause : Icon::play, scene::step_count(object) > 0,
                  say(walks ? walk_words::stop : walk_words::walk)))
    frame.output.commands.emplace_back(scene::SetParameter{"animation.playing", !walks});
  fitted_text(frame.ui, Face::bold, {x + 8, row.y + size / 2}, colour(frame.input.theme.ink), step_text(object, figure),
              row.x + row.width - x - 8);
}

}  // namespace

Sentence size_text(const Frame&, const scene::SubdivisionFigure& figure) {
  return say("{} points", figure.points.size());
}

Tools tools_of(const Frame& frame, const scene::SubdivisionFigure& figure) {
  const bool point = point_selected(frame, figure);
  return {{"draw", Icon::pencil, true, walk_words::draw, std::nullopt, "d"},
          {"add", Icon::add, point, walk_words::add, std::nullopt, "Insert"},
          {"remove", Icon::remove, point, walk_words::remove, std::nullopt, "Delete"}};
}

float strip_height(const Frame& frame, const scene::SubdivisionFigure&) {
  // A phone has little height for buttons, plot and figure.
  const float plot = frame.ui.touch ? 108.0F : std::clamp(0.25F * frame.stage.height, 132.0F, 190.0F);
  return plot + buttons_height(frame);
}

void draw_strip(Frame& frame, const Rect& place, const scene::SubdivisionFigure& figure) {
  const Theme& theme = frame.input.theme;
  const float buttons = buttons_height(frame);
  draw_walk(frame, {place.x, place.y, place.width, buttons}, figure);
  const Rect plot{place.x - 24, place.y + buttons, place.width + 24, place.height - buttons};
  const scene::SubdivisionCurveObject& object = walked(frame);
  if (object.degree == 1) {
    fitted_text(frame.ui, Face::regular, plot.centre(), colour(theme.ink_soft), say(walk_words::exact), plot.width,
                Align::centre);
    return;
  }
  std::array<LogSeries, 1> series{{{say("distance of the vertices to the limit"), theme.ink, {}}}};
  for (const scene::SubdivisionFigure::LevelDistance& distance : figure.distances)
    series[0].values.emplace_back(distance.level, distance.maximum);
  const LogPlotEvent event =
      log_plot(frame.ui, "levels", plot, {.series = series, .number_name = say("level"), .marked = figure.level});
  if (event.taken) take_gesture(frame);
  if (event.number && *event.number != figure.level) {
    const int level = std::min(*event.number, scene::most_levels(object));
    if (level <= object.levels)
      set_number(frame, "subdivision.step", level * scene::steps_of_level(object));
    else
      set_number(frame, "subdivision.levels", level);
  }
  if (event.let_go) end_gesture(frame);
}

void draw_readout(Frame& frame, float left, float y, const scene::SubdivisionFigure& figure) {
  const Theme& theme = frame.input.theme;
  frame.output.readouts.push_back({0, 0, left + (frame.ui.touch ? 120.0 : 170.0), y + 32.0});
  text(frame.ui, Face::bold, {left, y}, colour(theme.ink), say("{} vertices", figure.polygon.size()));
  y += 20;
  const auto level = static_cast<std::size_t>(figure.level);
  if (figure.pass == 0 && level < figure.distances.size())
    text(frame.ui, Face::regular, {left, y}, colour(theme.ink_soft),
         say("{} from the limit", text_of("%.2g", figure.distances[level].maximum)));
  if (!frame.input.drawing) return;
  y += 22;
  text(frame.ui, Face::bold, {left, y}, colour(theme.accent), say(walk_words::drawing));
}

}  // namespace knotwork::web
