#include "knotwork/scene/history.h"

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"

namespace knotwork::scene::history_test {
namespace {

Document start() { return find_chapter("blending-surface")->start_document(); }

SetPatchEdit move(int i, int j, double z) {
  PatchEdit edit;
  edit.translation.z() = z;
  return {{i, j}, edit};
}

SetParameter set(std::string id, ParameterValue value) { return {std::move(id), std::move(value)}; }

}  // namespace

TEST_CASE("history: undo and redo restore the document exactly, through many kinds of commands") {
  Document document = start();
  History history;
  std::vector<Document> states{document};
  const std::vector<Command> commands{
      set("topology.u", "open"),
      set("locals.u", 9.0),
      set("model", "plane"),
      move(3, 1, 0.1),
      set("display.frames", true),
      set("motion.amplitude", 0.3),
      ResetPatches{},
      set("blending.function", "rational"),
      set("blending.parameter", 5.0),
  };
  for (const Command& command : commands) {
    REQUIRE(history.perform(document, command));
    states.push_back(document);
    CHECK(history.undo_label() == describe(command));
  }
  for (std::size_t k = states.size() - 1; k > 0; --k) {
    CHECK(document == states[k]);
    REQUIRE(history.undo(document));
  }
  CHECK(document == start());
  CHECK_FALSE(history.can_undo());
  CHECK_FALSE(history.undo(document));
  CHECK(history.undo_label().empty());
  CHECK(history.redo_label() == "Open u");
  for (std::size_t k = 1; k < states.size(); ++k) {
    REQUIRE(history.redo(document));
    CHECK(document == states[k]);
  }
  CHECK_FALSE(history.redo(document));
}

TEST_CASE("history: a drag is one entry") {
  Document document = start();
  const Document before = document;
  History history;
  history.begin_gesture();
  for (int k = 1; k <= 20; ++k) REQUIRE(history.perform(document, move(0, 0, 0.01 * k)));
  history.end_gesture();
  const Document after = document;
  CHECK(history.undo_label() == "Move patch 0, 0");
  REQUIRE(history.undo(document));
  CHECK(document == before);
  CHECK_FALSE(history.can_undo());
  REQUIRE(history.redo(document));
  CHECK(document == after);
}

TEST_CASE("history: what changes nothing leaves no entry and keeps redo") {
  Document document = start();
  History history;
  REQUIRE(history.perform(document, move(0, 0, 0.2)));
  REQUIRE(history.undo(document));
  REQUIRE(history.perform(document, set("locals.u", 6.0)));
  CHECK_FALSE(history.can_undo());
  CHECK(history.can_redo());

  history.begin_gesture();
  REQUIRE(history.perform(document, move(1, 1, 0.2)));
  REQUIRE(history.perform(document, SetPatchEdit{{1, 1}, PatchEdit{}}));
  history.end_gesture();
  CHECK_FALSE(history.can_undo());
  CHECK(history.can_redo());
}

TEST_CASE("history: a cancelled gesture leaves the document as it was, but for camera and clock") {
  Document document = start();
  REQUIRE(apply(document, set("animation.playing", true)));
  const Document before = document;
  History history;
  history.begin_gesture();
  REQUIRE(history.perform(document, move(2, 2, 0.3)));
  REQUIRE(history.perform(document, AdvanceClock{0.25}));
  history.cancel_gesture(document);
  CHECK(document.objects == before.objects);
  CHECK(document.animation.time == 0.25);
  CHECK_FALSE(history.can_undo());
  CHECK_FALSE(history.can_redo());
}

TEST_CASE("history: a new entry forgets what was undone") {
  Document document = start();
  History history;
  REQUIRE(history.perform(document, move(0, 0, 0.2)));
  REQUIRE(history.undo(document));
  REQUIRE(history.perform(document, move(0, 1, 0.2)));
  CHECK_FALSE(history.can_redo());
}

TEST_CASE("history: undo leaves camera and clock alone, unless a document was loaded") {
  Document document = start();
  History history;
  REQUIRE(history.perform(document, move(0, 0, 0.2)));
  Camera camera = document.camera;
  camera.azimuth = 2;
  REQUIRE(history.perform(document, SetCamera{camera}));
  REQUIRE(history.perform(document, set("animation.playing", true)));
  REQUIRE(history.perform(document, AdvanceClock{0.5}));
  REQUIRE(history.undo(document));
  CHECK(document.camera.azimuth == 2);
  CHECK(document.animation.time == 0.5);
  CHECK(document.animation.playing);

  const Document before_load = document;
  REQUIRE(history.perform(document, LoadDocument{start()}));
  CHECK(document == start());
  REQUIRE(history.undo(document));
  CHECK(document == before_load);
  REQUIRE(history.redo(document));
  CHECK(document == start());
}

TEST_CASE("history: a refused command leaves document and history as they were") {
  Document document = start();
  History history;
  REQUIRE(history.perform(document, move(0, 0, 0.2)));
  REQUIRE(history.undo(document));
  const Document before = document;
  CHECK_FALSE(history.perform(document, set("locals.u", 1e9)));
  history.begin_gesture();
  CHECK_FALSE(history.perform(document, move(77, 0, 0.2)));
  history.end_gesture();
  CHECK(document == before);
  CHECK_FALSE(history.can_undo());
  CHECK(history.can_redo());
}

TEST_CASE("history: undo during a gesture ends it") {
  Document document = start();
  const Document before = document;
  History history;
  history.begin_gesture();
  REQUIRE(history.perform(document, move(0, 0, 0.2)));
  REQUIRE(history.undo(document));
  CHECK(document == before);
  REQUIRE(history.perform(document, move(0, 0, 0.3)));
  REQUIRE(history.perform(document, move(0, 0, 0.4)));
  REQUIRE(history.undo(document));
  CHECK(blending_surface(document).edits.at({0, 0}).translation.z() == 0.3);
}

TEST_CASE("history: holds at most its number of entries and of bytes, dropping the oldest") {
  Document document = start();
  History history;
  for (std::size_t k = 0; k < History::max_entries + 44; ++k) {
    REQUIRE(history.perform(document, move(0, 0, 0.001 * static_cast<double>(k + 1))));
  }
  std::size_t undone = 0;
  while (history.undo(document)) ++undone;
  CHECK(undone == History::max_entries);
  CHECK(blending_surface(document).edits.at({0, 0}).translation.z() == doctest::Approx(0.044));

  Document large = start();
  BlendingSurfaceObject& surface = blending_surface(large);
  surface.locals_u = surface.locals_v = max_locals;
  for (int i = 0; i < max_locals; ++i) {
    for (int j = 0; j < max_locals; ++j) surface.edits[{i, j}].translation.x() = 0.1;
  }
  History full;
  for (int k = 0; k < 40; ++k) REQUIRE(full.perform(large, move(0, 0, 0.1 * (k + 1))));
  undone = 0;
  while (full.undo(large)) ++undone;
  CHECK(undone >= 2);
  CHECK(undone < 40);
}

}  // namespace knotwork::scene::history_test
