#include "knotwork/scene/commands.h"

#include <limits>

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"

#include "unit/refused_command.h"

namespace knotwork::scene::commands_test {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

Document start() { return find_chapter("blending-surface")->start_document(); }

}  // namespace

TEST_CASE("commands: an edit is stored, replaced and removed by the identity") {
  Document document = start();
  PatchEdit edit;
  edit.translation = {0.1, 0, 0.2};
  REQUIRE(apply(document, SetPatchEdit{{5, 3}, edit}));
  CHECK(blending_surface(document).edits.at({5, 3}) == edit);
  edit.scale = {2, 1, 0.5};
  REQUIRE(apply(document, SetPatchEdit{{5, 3}, edit}));
  CHECK(blending_surface(document).edits.at({5, 3}) == edit);
  REQUIRE(apply(document, SetPatchEdit{{5, 3}, PatchEdit{}}));
  CHECK(blending_surface(document).edits.count({5, 3}) == 0);
  REQUIRE(apply(document, ResetPatches{}));
  CHECK(blending_surface(document).edits.empty());
}

TEST_CASE("commands: a bad edit is refused, naming the member") {
  const auto with = [](auto change) {
    PatchEdit edit;
    edit.translation.x() = 0.5;
    change(edit);
    return SetPatchEdit{{0, 0}, edit};
  };
  CHECK(refusal(start(), with([](PatchEdit& e) { e.translation.y() = not_a_number; })).path == "translation[1]");
  CHECK(refusal(start(), with([](PatchEdit& e) { e.translation.z() = -infinity; })).path == "translation[2]");
  CHECK(refusal(start(), with([](PatchEdit& e) { e.translation.z() = 1e7; })).path == "translation[2]");
  CHECK(refusal(start(), with([](PatchEdit& e) { e.scale.x() = 0; })).path == "scale[0]");
  CHECK(refusal(start(), with([](PatchEdit& e) { e.scale.x() = 101; })).path == "scale[0]");
  CHECK(refusal(start(), with([](PatchEdit& e) { e.rotation.coeffs().setZero(); })).path == "rotation");
  CHECK(refusal(start(), with([](PatchEdit& e) { e.rotation.coeffs() *= 1.001; })).path == "rotation[3]");
  CHECK(refusal(start(), with([](PatchEdit& e) { e.rotation.coeffs() *= 0.9; })).path == "rotation");
  CHECK(refusal(start(), with([](PatchEdit& e) { e.rotation.x() = not_a_number; })).path == "rotation[0]");
  for (PatchIndex patch : {PatchIndex{-1, 0}, {6, 0}, {0, 4}, {0, -2}}) {
    CHECK(refusal(start(), SetPatchEdit{patch, PatchEdit{}}).path == "patch");
  }
}

TEST_CASE("commands: the camera stays within its limits") {
  Document document = start();
  Camera camera = document.camera;
  camera.distance = 3;
  REQUIRE(apply(document, SetCamera{camera}));
  CHECK(document.camera == camera);
  camera.distance = 0;
  CHECK(refusal(document, SetCamera{camera}).path == "camera.distance");
  camera.distance = not_a_number;
  CHECK(refusal(document, SetCamera{camera}).path == "camera.distance");
  camera = Camera{};
  camera.elevation = 1.6;
  CHECK(refusal(document, SetCamera{camera}).path == "camera.elevation");
  camera = Camera{};
  camera.target.y() = infinity;
  CHECK(refusal(document, SetCamera{camera}).path == "camera.target[1]");
}

TEST_CASE("commands: the clock moves while playing, at its speed, and wraps") {
  Document document = start();
  REQUIRE(apply(document, AdvanceClock{1}));
  CHECK(document.animation.time == 0);
  REQUIRE(apply(document, SetParameter{"animation.playing", true}));
  REQUIRE(apply(document, SetParameter{"animation.speed", 2.0}));
  REQUIRE(apply(document, AdvanceClock{1.5}));
  CHECK(document.animation.time == 3);
  REQUIRE(apply(document, AdvanceClock{2}));
  CHECK(document.animation.time == doctest::Approx(7 - clock_period));
  for (int k = 0; k < 1000; ++k) {
    REQUIRE(apply(document, AdvanceClock{0.37}));
    REQUIRE(document.animation.time >= 0);
    REQUIRE(document.animation.time < clock_period);
  }
  for (double seconds : {not_a_number, infinity, -1.0, 1e300})
    CHECK(refusal(document, AdvanceClock{seconds}).path == "seconds");
}

TEST_CASE("commands: a document is checked before it is loaded") {
  Document document = start();
  Document other = start();
  blending_surface(other).locals_u = 3;
  REQUIRE(apply(document, LoadDocument{other}));
  CHECK(document == other);

  Document empty = other;
  empty.objects.clear();
  CHECK(refusal(start(), LoadDocument{empty}).path == "objects");
  Document counts = other;
  blending_surface(counts).locals_v = 1000000000;
  CHECK(refusal(start(), LoadDocument{counts}).path == "objects[0].locals.v");
  Document closed = other;
  blending_surface(closed).model = cylinder_surface();
  CHECK(refusal(start(), LoadDocument{closed}).path == "objects[0].topology.u");
  Document index = other;
  blending_surface(index).edits[{200, 0}].translation.x() = 1;
  CHECK(refusal(start(), LoadDocument{index}).path.find("objects[0].patches[") == 0);
}

TEST_CASE("commands: an unknown parameter is refused by its name") {
  const Error error = refusal(start(), SetParameter{"topology.w", "open"});
  CHECK(error.path == "topology.w");
  CHECK_FALSE(in_history(SetParameter{"topology.w", "open"}));
  CHECK(describe(SetParameter{"topology.w", "open"}) == "Set topology.w");
}

TEST_CASE("commands: history takes back all but camera and clock") {
  CHECK(in_history(SetParameter{"locals.u", 5.0}));
  CHECK(in_history(SetParameter{"animation.speed", 2.0}));
  CHECK_FALSE(in_history(SetParameter{"animation.time", 2.0}));
  CHECK_FALSE(in_history(SetParameter{"animation.playing", true}));
  CHECK(in_history(SetPatchEdit{}));
  CHECK(in_history(ResetPatches{}));
  CHECK(in_history(LoadDocument{}));
  CHECK_FALSE(in_history(SetCamera{}));
  CHECK_FALSE(in_history(AdvanceClock{}));
}

TEST_CASE("commands: descriptions read like a menu") {
  CHECK(describe(SetParameter{"topology.u", "closed"}) == "Close u");
  CHECK(describe(SetParameter{"topology.v", "open"}) == "Open v");
  CHECK(describe(SetParameter{"model", "torus"}) == "Change the model to Torus");
  CHECK(describe(SetParameter{"locals.u", 7.0}) == "Set locals u to 7");
  CHECK(describe(SetParameter{"display.frames", true}) == "Show frames");
  CHECK(describe(SetParameter{"display.frames", false}) == "Hide frames");
  PatchEdit edit;
  edit.translation.z() = 1;
  CHECK(describe(SetPatchEdit{{2, 1}, edit}) == "Move patch 2, 1");
  CHECK(describe(SetPatchEdit{{2, 1}, PatchEdit{}}) == "Reset patch 2, 1");
  for (const Command& command :
       {Command(ResetPatches{}), Command(SetCamera{}), Command(LoadDocument{}), Command(AdvanceClock{})}) {
    CHECK_FALSE(describe(command).empty());
  }
}

TEST_CASE("commands: a model that cannot stay closed says what it opens") {
  Document document = start();
  CHECK(notice(document, SetParameter{"model", "plane"}) == "The plane is not closed in u and v, so u and v open.");
  CHECK(notice(document, SetParameter{"model", "cylinder"}) == "The cylinder is not closed in u, so u opens.");
  CHECK(notice(document, SetParameter{"model", "torus"}).empty());
  CHECK(notice(document, SetParameter{"model", "sphere"}) == "The sphere is not closed in v, so v opens.");
  CHECK(notice(document, SetParameter{"model", "teapot"}).empty());
  CHECK(notice(document, SetParameter{"locals.u", 3.0}).empty());
  CHECK(notice(document, ResetPatches{}).empty());
}

}  // namespace knotwork::scene::commands_test
