#include "knotwork/scene/document_json.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/history.h"
#include "unit/float_traps.h"

namespace knotwork::scene::document_json_test {
using Json = nlohmann::ordered_json;

namespace {

Document start() { return find_chapter("blending-surface")->start_document(); }

/// A document with every kind of thing in it and numbers that need all their digits.
Document rich() {
  Document document = start();
  BlendingSurfaceObject surface;
  surface.model = cylinder_surface(1.0 / 3, std::nextafter(2.0, 3.0), 0.1);
  surface.topology_u = Topology::open;
  surface.blending = BlendingKind::rational;
  surface.blending_parameter = 3;
  surface.locals_u = 128;
  surface.patches = {LocalSurfaceKind::bezier_hermite, 1, 2};
  PatchEdit edit;
  edit.translation = {-0.0, 1e-300, 999999.99999999988};
  edit.rotation = Eigen::AngleAxisd(1.0 / 7, Eigen::Vector3d(2, 3, 6) / 7);
  edit.scale = {0.01, 100, std::sqrt(2.0)};
  surface.edits[{127, 3}] = edit;
  surface.edits[{0, 0}] = PatchEdit{};
  document.objects.push_back({"second-1",
                              "Zweite Fl\xC3\xA4"
                              "che \"\\ \n",
                              surface});
  document.camera = {{1e-17, -1e6, 0.1 + 0.2}, 5, 12.5, -1.57};
  document.display = {.surface = false,
                      .patch_colours = false,
                      .knot_lines = false,
                      .wireframe = true,
                      .local_patches = true,
                      .frames = true,
                      .normals = true,
                      .handles = false,
                      .polygon = true,
                      .construction = false,
                      .comb = true,
                      .osculating = true,
                      .hodograph = true,
                      .continuity = true,
                      .shading = Shading::mean,
                      .adaptive = false,
                      .rings = {{0.1, -2, 1e-9}}};
  document.animation = {true, 6.2831853, 0.1, MotionKind::report, 1.5, 0.25, 1.0};
  return document;
}

Json json_of(const Document& document) { return Json::parse(write_document(document), nullptr, false); }

/// The error of a text that must be refused.
Error refusal(std::string_view text) {
  const Result<Document> result = parse_document(text);
  REQUIRE_FALSE(result);
  CHECK_FALSE(result.error().message.empty());
  return result.error();
}

/// The path of the error when the member at the JSON pointer is replaced.
std::string path_with(const char* pointer, Json value) {
  Json json = json_of(start());
  json[Json::json_pointer(pointer)] = std::move(value);
  return refusal(json.dump()).path;
}

std::string path_without(const char* parent, const char* member) {
  Json json = json_of(start());
  json[Json::json_pointer(parent)].erase(member);
  return refusal(json.dump()).path;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  REQUIRE(place != std::string::npos);
  return text.replace(place, from.size(), to);
}

std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("document JSON: what is written is read again bit for bit") {
  for (const Document& document : {start(), rich()}) {
    const std::string text = write_document(document);
    const Result<Document> again = parse_document(text);
    REQUIRE(again);
    CHECK(again.value() == document);
    CHECK(write_document(again.value()) == text);
  }
  const Result<Document> again = parse_document(write_document(rich()));
  const auto& second = std::get<BlendingSurfaceObject>(again.value().objects[1].shape);
  CHECK(std::signbit(second.edits.at({127, 3}).translation.x()));
}

TEST_CASE("document JSON: every model keeps its measures") {
  for (const ModelSurface& model :
       {ModelSurface(plane_surface({1, 2, 3}, {0, 1, 0}, {0.5, 0, 1})), ModelSurface(cylinder_surface(1, 2, 3)),
        ModelSurface(torus_surface(3, 2, 1)), ModelSurface(Sheet{1, 1, 0.1, 0.2, 0.3, 0.4})}) {
    Document document = start();
    BlendingSurfaceObject& surface = blending_surface(document);
    surface.model = model;
    if (!closes_u(model)) surface.topology_u = Topology::open;
    if (!closes_v(model)) surface.topology_v = Topology::open;
    const Result<Document> again = parse_document(write_document(document));
    REQUIRE(again);
    CHECK(again.value() == document);
  }
}

TEST_CASE("document JSON: every model is written with its measures by their ids, and read again") {
  for (const ModelRow& row : model_kinds()) {
    CAPTURE(row.id);
    Document document = start();
    BlendingSurfaceObject& surface = blending_surface(document);
    surface.model = make_model(row.kind);
    if (!closes_u(surface.model)) surface.topology_u = Topology::open;
    if (!closes_v(surface.model)) surface.topology_v = Topology::open;
    const Json model = json_of(document)["objects"][0]["model"];
    CHECK(model["kind"] == std::string(row.id));
    CHECK(model.size() == 1 + model_measures(row.kind).size());
    for (const CatalogueMeasure& measure : model_measures(row.kind)) {
      CHECK(model[std::string(measure.id)] == measure.standard);
    }
    const Result<Document> again = parse_document(write_document(document));
    REQUIRE(again);
    CHECK(again.value() == document);
  }
}

TEST_CASE("document JSON: a twisted turn needs patches that fall onto each other") {
  Json json = json_of(start());
  Json& object = json["objects"][0];
  object["model"] = {{"kind", "klein-bottle"}, {"width", 0.6}, {"height", 1.6}, {"tubeRadius", 0.4}};
  CHECK(parse_document(json.dump()));
  object["locals"]["v"] = 5;
  const Error odd = refusal(json.dump());
  CHECK(odd.path == "objects[0].locals.v");
  CHECK(odd.message == "Going round the Klein bottle in u reflects the patches in v: their number must be even.");
  object["locals"]["v"] = 4;
  object["topology"]["v"] = "open";
  CHECK(refusal(json.dump()).path == "objects[0].topology.v");
  object["topology"]["u"] = "open";
  CHECK(parse_document(json.dump()));
  object["locals"]["kind"] = "arc";
  CHECK(refusal(json.dump()).path == "objects[0].locals.kind");
  object["locals"]["kind"] = "bezier-hermite";
  object["locals"]["degreeU"] = 4;
  CHECK(refusal(json.dump()).path == "objects[0].locals.degreeU");
}

TEST_CASE("document JSON: has the promised shape") {
  const Json json = json_of(start());
  CHECK(json["format"] == "knotwork");
  CHECK(json["version"] == 1);
  const Json& object = json["objects"][0];
  CHECK(object["id"] == "surface");
  CHECK(object["kind"] == "blendingSurface");
  CHECK(object["model"]["kind"] == "sheet");
  CHECK(object["topology"] == Json({{"u", "closed"}, {"v", "closed"}}));
  CHECK(object["locals"] == Json({{"u", 6}, {"v", 4}, {"kind", "sub-surface"}, {"degreeU", 3}, {"degreeV", 3}}));
  CHECK(object["blending"]["function"] == "polynomial2");
  CHECK(object["patches"][0]["i"] == 2);
  CHECK(object["patches"][0]["translation"] == Json({0.0, 0.0, 0.55}));
  CHECK(json["animation"]["motion"] == "breathe");
}

TEST_CASE("document JSON: a wrong type is an error at its place") {
  CHECK(path_with("/objects", 3) == "objects");
  CHECK(path_with("/objects/0", "surface") == "objects[0]");
  CHECK(path_with("/objects/0/id", 7) == "objects[0].id");
  CHECK(path_with("/objects/0/label", nullptr) == "objects[0].label");
  CHECK(path_with("/objects/0/model", Json::array()) == "objects[0].model");
  CHECK(path_with("/objects/0/locals/u", "6") == "objects[0].locals.u");
  CHECK(path_with("/objects/0/locals/u", 6.5) == "objects[0].locals.u");
  CHECK(path_with("/objects/0/locals", 6) == "objects[0].locals");
  CHECK(path_with("/objects/0/patches", Json::object()) == "objects[0].patches");
  CHECK(path_with("/objects/0/patches/0", 1) == "objects[0].patches[0]");
  CHECK(path_with("/objects/0/patches/0/translation", 1) == "objects[0].patches[0].translation");
  CHECK(path_with("/objects/0/patches/0/translation", {1, 2}) == "objects[0].patches[0].translation");
  CHECK(path_with("/objects/0/patches/0/scale", {1, 1, true}) == "objects[0].patches[0].scale[2]");
  CHECK(path_with("/camera/distance", "far") == "camera.distance");
  CHECK(path_with("/display/surface", 1) == "display.surface");
  CHECK(path_with("/animation/motion", 0) == "animation.motion");
  CHECK(path_with("/version", "1") == "version");
  CHECK(path_with("/format", 1) == "format");
}

TEST_CASE("document JSON: missing and unknown members are errors at their place") {
  for (const char* member : {"format", "version", "objects", "camera", "display", "animation"}) {
    CHECK(path_without("", member) == member);
  }
  CHECK(path_without("/objects/0", "patches") == "objects[0].patches");
  CHECK(path_without("/objects/0/model", "kind") == "objects[0].model.kind");
  CHECK(path_without("/objects/0/model", "flatRadiusU") == "objects[0].model.flatRadiusU");
  CHECK(path_without("/objects/0/patches/0", "j") == "objects[0].patches[0].j");
  CHECK(path_without("/camera", "azimuth") == "camera.azimuth");
  CHECK(path_with("/objects/0/colour", "red") == "objects[0].colour");
  CHECK(path_with("/objects/0/model/wheelRadius", 1) == "objects[0].model.wheelRadius");
  CHECK(path_with("/extra", 1) == "extra");
}

TEST_CASE("document JSON: numbers out of range are errors at their place") {
  for (const Json& count :
       {Json(0), Json(1), Json(-3), Json(129), Json(1000000000), Json(1e300), Json(18446744073709551615u)}) {
    CHECK(path_with("/objects/0/locals/u", count) == "objects[0].locals.u");
  }
  CHECK(refusal(replaced(write_document(start()), "\"u\":6", "\"u\":0")).message ==
        "Must be a whole number from 2 to 128.");
  CHECK(path_with("/objects/0/samples/v", 7) == "objects[0].samples.v");
  CHECK(path_with("/objects/0/samples/v", 1025) == "objects[0].samples.v");
  CHECK(path_with("/objects/0/model/closedRadiusU", 0) == "objects[0].model.closedRadiusU");
  CHECK(path_with("/objects/0/model/closedRadiusU", -1) == "objects[0].model.closedRadiusU");
  CHECK(path_with("/objects/0/patches/0/i", 128) == "objects[0].patches[0].i");
  CHECK(path_with("/objects/0/patches/0/translation/1", 2e6) == "objects[0].patches[0].translation[1]");
  CHECK(path_with("/objects/0/patches/0/scale/0", 0) == "objects[0].patches[0].scale[0]");
  CHECK(path_with("/objects/0/patches/0/rotation", {0, 0, 0, 0}) == "objects[0].patches[0].rotation");
  CHECK(path_with("/objects/0/patches/0/rotation", {0, 0, 0.1, 1}) == "objects[0].patches[0].rotation");
  CHECK(path_with("/animation/speed", 0) == "animation.speed");
  CHECK(path_with("/animation/time", 7) == "animation.time");
  CHECK(path_with("/camera/elevation", 1.58) == "camera.elevation");
  CHECK(path_with("/objects", Json::array()) == "objects");
}

TEST_CASE("document JSON: NaN, infinity and numbers beyond doubles are errors") {
  const test::FloatTrapsOff traps_off;
  const std::string text = write_document(start());
  CHECK(path_with("/camera/distance", "NaN") == "camera.distance");
  CHECK(path_with("/camera/distance", nullptr) == "camera.distance");
  for (const char* number : {"NaN", "nan", "Infinity", "-Infinity", "0x10", "+1", "1.", ".5", "01"}) {
    CAPTURE(number);
    const Error error = refusal(replaced(text, "\"distance\":5.2", std::string("\"distance\":") + number));
    CHECK(error.path.find("camera") == 0);
    CHECK(error.message.find("line 1, column ") != std::string::npos);
  }
  const Error error = refusal(replaced(text, "\"distance\":5.2", "\"distance\":1e999"));
  CHECK(error.path == "camera.distance");
  CHECK(error.message == "Is a number too large to be stored: 1e999.");
}

TEST_CASE("document JSON: unknown choices and other versions are errors that name what is known") {
  CHECK(path_with("/objects/0/topology/u", "ajar") == "objects[0].topology.u");
  CHECK(path_with("/objects/0/model/kind", "teapot") == "objects[0].model.kind");
  CHECK(path_with("/objects/0/blending/function", "cubic") == "objects[0].blending.function");
  CHECK(path_with("/objects/0/kind", "curve") == "objects[0].kind");
  CHECK(path_with("/animation/motion", "waltz") == "animation.motion");
  CHECK(path_with("/format", "knotworks") == "format");
  CHECK(path_with("/version", 2) == "version");
  CHECK(path_with("/version", 0) == "version");
  CHECK(path_with("/version", 1.5) == "version");
  CHECK(refusal(replaced(write_document(start()), "\"closed\"", "\"Closed\"")).message == "Must be open or closed.");
}

TEST_CASE("document JSON: members that contradict each other are errors") {
  Json json = json_of(start());
  json["objects"].push_back(json["objects"][0]);
  CHECK(refusal(json.dump()).path == "objects[1].id");

  json = json_of(start());
  json["objects"][0]["patches"].push_back(json["objects"][0]["patches"][0]);
  CHECK(refusal(json.dump()).path == "objects[0].patches[1]");

  Json plane{{"kind", "plane"}};
  for (const char* zero : {"originX", "originY", "originZ", "uAxisY", "uAxisZ", "vAxisX", "vAxisZ"}) plane[zero] = 0;
  plane["uAxisX"] = plane["vAxisY"] = 1;
  CHECK(path_with("/objects/0/model", plane) == "objects[0].topology.u");
  json = json_of(start());
  json["objects"][0]["topology"] = {{"u", "open"}, {"v", "open"}};
  json["objects"][0]["model"] = plane;
  CHECK(parse_document(json.dump()));
  json["objects"][0]["model"]["vAxisX"] = 2;
  json["objects"][0]["model"]["vAxisY"] = 0;
  CHECK(refusal(json.dump()).path == "objects[0].model.vAxisX");

  CHECK(path_with("/objects/0/blending", {{"function", "rational"}, {"parameter", 1}}) ==
        "objects[0].blending.parameter");
  CHECK(path_with("/objects/0/id", "No Slug") == "objects[0].id");
  CHECK(path_with("/objects/0/id", "") == "objects[0].id");
  CHECK(path_with("/objects/0/id", std::string(65, 'a')) == "objects[0].id");
  CHECK(path_with("/objects/0/label", std::string(201, 'x')) == "objects[0].label");
}

TEST_CASE("document JSON: a key given twice is an error") {
  const std::string text = write_document(start());
  CHECK(refusal(replaced(text, "\"distance\":5.2", "\"distance\":5.2,\"distance\":6")).path == "camera.distance");
  CHECK(refusal(replaced(text, "\"version\":1", "\"version\":1,\"version\":1")).path == "version");
}

TEST_CASE("document JSON: junk of every size is refused") {
  const std::string text = write_document(start());
  CHECK(refusal("").message.find("line 1, column 1") != std::string::npos);
  CHECK(refusal("null").message == "Must be an object.");
  CHECK(refusal("[]").message == "Must be an object.");
  CHECK(refusal("{}").path == "format");
  CHECK(refusal("\xff\xfe").path.empty());
  CHECK(refusal(text + "x").path.empty());
  CHECK(refusal(text + text).path.empty());
  CHECK(refusal(std::string_view("\0\0\0", 3)).path.empty());
  for (std::size_t length = 0; length < text.size(); ++length) REQUIRE_FALSE(parse_document(text.substr(0, length)));

  CHECK(refusal(std::string(max_document_bytes + 1, ' ')).message == "The document is larger than 8 MiB.");
  CHECK(refusal(std::string(max_document_bytes, 'x')).path.empty());
  CHECK(refusal('"' + std::string(max_document_bytes - 2, 'x') + '"').message == "Must be an object.");
  CHECK_FALSE(parse_document(std::string(100000, '[')));
  std::string objects;
  for (int k = 0; k < 100000; ++k) objects += "{\"a\":";
  CHECK(refusal(objects).message == "Is nested deeper than anything in a document.");

  std::string wide = "[0";
  for (int k = 0; k < 100000; ++k) wide += ",0";
  CHECK(refusal(wide + "]").message == "Is in a longer list than any in a document.");
  CHECK(refusal("{\"patches\":" + wide + "]}").path == "patches[16384]");
  CHECK(refusal("{\"points\":" + wide + "]}").path == "points[20000]");
  std::string keys = "{\"k\":0";
  for (int k = 0; k < 100000; ++k) keys += ",\"k" + std::to_string(k) + "\":0";
  CHECK(refusal(keys + "}").message == "Is in an object with more members than any in a document.");
  std::string lists = "[";
  for (int k = 0; k < 1000; ++k) {
    lists += k == 0 ? "[0" : ",[0";
    for (int l = 0; l < 1000; ++l) lists += ",0";
    lists += ']';
  }
  CHECK(refusal(lists + "]").message == "There are more values than in any document.");
}

TEST_CASE("document JSON: a document with every patch edited is read") {
  Document document = start();
  BlendingSurfaceObject& surface = blending_surface(document);
  surface.locals_u = surface.locals_v = max_locals;
  for (int i = 0; i < max_locals; ++i) {
    for (int j = 0; j < max_locals; ++j) {
      PatchEdit& edit = surface.edits[{i, j}];
      edit.translation = {std::sin(i), -std::sin(j), 1e-5 * std::sin(i + j)};
      edit.rotation = Eigen::AngleAxisd(i + 0.1 * j, Eigen::Vector3d(2, 3, 6) / 7);
    }
  }
  const std::string text = write_document(document);
  CHECK(text.size() < max_document_bytes);
  const Result<Document> again = parse_document(text);
  REQUIRE(again);
  CHECK(again.value() == document);
  document.objects.push_back({"more", "More", BlendingSurfaceObject{}});
  std::get<BlendingSurfaceObject>(document.objects[1].shape).edits[{0, 0}].translation.x() = 1;
  CHECK(check(document).error().path == "objects[1].patches");
}

TEST_CASE("document JSON: a refused document leaves document and history alone") {
  Document document = start();
  History history;
  REQUIRE(history.perform(document, SetParameter{"locals.u", 7.0}));
  const Document before = document;
  const Result<Document> bad = parse_document(replaced(write_document(document), "\"u\":7", "\"u\":1000000000"));
  CHECK_FALSE(bad);
  Document invalid = start();
  blending_surface(invalid).locals_u = 0;
  CHECK_FALSE(history.perform(document, LoadDocument{invalid}));
  CHECK(document == before);
  CHECK(history.undo_label() == "Set locals u to 7");
}

TEST_CASE("document JSON: the files of tests/data/documents are read or refused as their names say") {
  namespace fs = std::filesystem;
  const test::FloatTrapsOff traps_off;
  const fs::path folder = fs::path(KNOTWORK_TEST_DATA_DIR) / "documents";
  int good = 0, bad = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    CAPTURE(name);
    const Result<Document> result = parse_document(file_text(entry.path()));
    if (name.find("good-") == 0) {
      CHECK(result);
      ++good;
    } else {
      REQUIRE(name.find("bad-") == 0);
      CHECK_FALSE(result);
      ++bad;
    }
  }
  CHECK(good >= 4);
  CHECK(bad >= 12);
}

}  // namespace knotwork::scene::document_json_test
