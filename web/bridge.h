#pragma once

#include <cstdint>

/// What the shell may call: the one border between TypeScript and C++. Strings are UTF-8; a returned string lives until
/// the next call that returns one. JSON answers are {"value": ...} or {"error": {"message": "...", "path": "..."}}.
/// When the module needs a frame (an event, a command, a font) it calls the function that the page gave as
/// `onFrameNeeded` in the module's options; the page then calls knotwork_frame at its next animation frame.
/// Positions are CSS pixels from the stage's upper left corner; times are milliseconds of performance.now().
extern "C" {
// Life. `knotwork_start` needs the canvas (a CSS selector) in the page; false when WebGL2 is not to be had.
bool knotwork_start(const char* canvas_selector);
void knotwork_font(const std::uint8_t* bytes, int size,
                   int weight);  ///< a TrueType file for the panel, 400 or 600; copied
void knotwork_resize(double css_width, double css_height, double pixel_ratio);
void knotwork_scheme(bool dark);
void knotwork_reduced_motion(bool reduced);
void knotwork_complete();             ///< the module's part that fits grids is here
bool knotwork_context(bool present);  ///< the WebGL context was lost (false) or is back (true); whether it can draw
/// Draws one frame if one is needed. True: call again at the next animation frame. False: idle until the next event.
bool knotwork_frame(double now);

// Input. type: 0 move, 1 down, 2 up, 3 cancel, 4 leave. device: 0 mouse, 1 pen, 2 touch. button: 0 left, 1 middle,
// 2 right, -1 none. modifiers: 1 shift, 2 ctrl, 4 alt, 8 meta. Each asks the page for a frame where one is needed and
// returns 1 when the event was used (the page then prevents its default).
int knotwork_pointer(int type, int id, int device, double x, double y, int button, int modifiers, double time);
int knotwork_wheel(double delta_x, double delta_y, double x, double y, int modifiers);
int knotwork_key(bool down, const char* key, int modifiers);  ///< KeyboardEvent.key
void knotwork_focus(bool focused);
const char* knotwork_cursor();  ///< a CSS cursor for the stage

// The script interface (DESIGN "The script interface"); the shell wraps these as window.knotwork.
const char* knotwork_version();  ///< plain text, not JSON
const char* knotwork_document();
const char* knotwork_load(const char* json);
const char* knotwork_parameters();
const char* knotwork_set_number(const char* id, double value);
const char* knotwork_set_choice(const char* id, const char* value);
const char* knotwork_set_toggle(const char* id, bool value);
const char* knotwork_handles();  ///< screen relative to the stage
const char* knotwork_widgets();  ///< rect relative to the stage
const char* knotwork_evaluate_curve(const char* object, double t, int order);
const char* knotwork_evaluate_surface(const char* object, double u, double v, int order);
const char* knotwork_play(bool playing);
const char* knotwork_seek(double seconds);
/// Commands between an opened and a closed gesture are one step of undo (a drag of a range beside the prose).
void knotwork_gesture(bool open);
const char* knotwork_undo();
const char* knotwork_redo();
const char* knotwork_stats();
const char* knotwork_chapters();
const char* knotwork_open(const char* chapter);

/// What the page beside the stage shows, asked for after a frame when knotwork_revision() has changed:
/// {canUndo, canRedo, undoLabel, redoLabel, notice, selected, points, surface: {shape, u: {topology, domain, knots,
///  patches, locals}, v: {...}}}; `notice` is a sentence for a live region (a refusal, what was selected), `points` how
/// many a figure is made from that is made from a list of them (else null), `surface` null while there is none, `domain`
/// text as "[u₁, u₇)", `shape` "plane", "cylinder" or "torus".
const char* knotwork_state();
double knotwork_revision();
/// A handle is selected (by its id from handles(), or "" for none) and moved by keys.
const char* knotwork_select(const char* handle);
/// Points as text (point_text.h) replace those of the figure on the stage.
const char* knotwork_points(const char* text);
bool knotwork_enter_scene(const char* name);     ///< true: it has been on the stage before, and is as it was left
void knotwork_begin_scene(bool again);           ///< again: the history stays, so that it can be undone
const char* knotwork_measure(const char* name);  ///< scene::measure(), null where there is none
}
