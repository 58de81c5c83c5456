#pragma once

#include <span>
#include <string>
#include <string_view>

#include "knotwork/later.h"
#include "web/app.h"

namespace knotwork::web {

// window.knotwork's functions (DESIGN "The script interface") as JSON texts: {"value": ...} or
// {"error": {"message", "path"}}. An error has changed nothing.

std::string answer_document(const App& app);
KNOTWORK_LATER std::string answer_load(App& app, std::string_view json);
std::string answer_parameters(const App& app);
std::string answer_set(App& app, std::string_view id, const scene::ParameterValue& value);
std::string answer_handles(App& app);
std::string answer_widgets(const App& app);
/// At t of a curve, at u and v of a surface.
KNOTWORK_LATER std::string answer_evaluate(const App& app, std::string_view object, std::span<const double> at,
                                           int order);
std::string answer_play(App& app, bool playing);
std::string answer_seek(App& app, double seconds);
std::string answer_undo(App& app);
std::string answer_redo(App& app);
std::string answer_stats(const App& app);
std::string answer_chapters();
std::string answer_open(App& app, std::string_view chapter);
/// Points as text take the place of those of the figure on the stage.
KNOTWORK_LATER std::string answer_measure(const App& app, std::string_view name);
KNOTWORK_LATER std::string answer_points(App& app, std::string_view text);
std::string answer_select(App& app, std::string_view handle);

/// What the page beside the stage shows (bridge.h, knotwork_state).
std::string answer_state(const App& app);

}  // namespace knotwork::web
