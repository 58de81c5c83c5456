// The JSON Schema beside the code says the same as the code: same members, same limits, same choices.

#include <fstream>
#include <set>
#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "knotwork/scene/document_members.h"

namespace knotwork::scene::document_schema_test {
using Json = nlohmann::json;

namespace {

/// An Io as document_members.h describes them: looks each member up in the schema and compares.
class SchemaComparison {
 public:
  static constexpr bool reads = false;

  SchemaComparison(const Json& root, const Json& schema) : root_(root), schema_(&schema) {}

  /// Compares the members that `visit` names with those of the present schema, in both directions.
  template <class F>
  void object(const Json& schema, F visit) {
    const Json* outer = std::exchange(schema_, &schema);
    std::set<std::string> outer_names = std::exchange(names_, {});
    expect(schema.value("type", "") == "object", "type");
    expect(schema.contains("additionalProperties") && schema["additionalProperties"] == false, "additionalProperties");
    visit();
    std::set<std::string> stated, required;
    const Json properties = schema.value("properties", Json::object());
    for (const auto& [name, value] : properties.items()) stated.insert(name);
    for (const Json& name : schema.value("required", Json::array())) required.insert(name.get<std::string>());
    expect(stated == names_, "properties");
    for (const std::string& name : later_) names_.erase(name);
    expect(required == names_, "required");
    schema_ = outer;
    names_ = std::move(outer_names);
  }

  void constant(std::string_view name, std::string_view value) { equal(member(name), "const", std::string(value)); }
  void constant(std::string_view name, int value) { equal(member(name), "const", value); }
  void toggle(std::string_view name, bool) { equal(member(name), "type", "boolean"); }
  void later_toggle(std::string_view name, bool value) {
    toggle(name, value);
    later_.insert(std::string(name));
  }

  template <class E>
  void later_choice(std::string_view name, E value) {
    choice(name, value);
    later_.insert(std::string(name));
  }
  void later_points(std::string_view name, const std::vector<Eigen::Vector3d>& list, const Limits& count) {
    points(name, list, count);
    later_.insert(std::string(name));
  }

  void text(std::string_view name, const std::string&, const Limits& length, bool slug) {
    const Json& schema = member(name);
    equal(schema, "type", "string");
    equal(schema, "minLength", length.min);
    equal(schema, "maxLength", length.max);
    if (slug) equal(schema, "pattern", "^[a-z][a-z0-9-]*$");
  }

  void number(std::string_view name, double, const Limits& range) { numeric(member(name), "number", range); }
  void integer(std::string_view name, int, const Limits& range) { numeric(member(name), "integer", range); }

  template <class E>
  void choice(std::string_view name, E value) {
    const Json& schema = member(name);
    // The kind of a model is a constant of each alternative; that there is one for each is compared below.
    if (schema.contains("const")) return equal(schema, "const", std::string(id_of(value)));
    Json ids = Json::array();
    for (int i = 0; i < ids_of(value).count; ++i) ids.push_back(std::string(ids_of(value).id(i)));
    equal(schema, "enum", ids);
  }

  void vector(std::string_view name, const Eigen::Vector3d&, const Limits& range) { numbers(member(name), 3, range); }
  void quaternion(std::string_view name, const Eigen::Quaterniond&, const Limits& range) {
    numbers(member(name), 4, range);
  }

  template <class F>
  void group(std::string_view name, F visit) {
    const Json& schema = member(name);
    if (!schema.contains("oneOf")) return object(schema, visit);
    if (find_catalogue_curve(schema["oneOf"][0]["properties"]["kind"]["const"].get<std::string>()) != nullptr)
      return curves(schema);
    // A model: every alternative, by its kind.
    expect(schema["oneOf"].size() == model_kinds().size(), "oneOf");
    for (const ModelRow& row : model_kinds()) {
      for (const Json& alternative : schema["oneOf"]) {
        if (alternative["properties"]["kind"]["const"] != std::string(row.id)) continue;
        const ModelSurface model = make_model(row.kind);
        object(alternative, [&] { members(*this, model); });
        ++models_;
      }
    }
  }

  /// A curve of the catalogue: every alternative, by its kind.
  void curves(const Json& schema) {
    expect(schema["oneOf"].size() == curve_catalogue().size(), "oneOf");
    for (std::size_t row = 0; row < curve_catalogue().size(); ++row) {
      for (const Json& alternative : schema["oneOf"]) {
        if (alternative["properties"]["kind"]["const"] != std::string(curve_catalogue()[row].id)) continue;
        const CatalogueCurve curve = standard_curve(static_cast<int>(row));
        object(alternative, [&] { members(*this, curve); });
        ++curves_;
      }
    }
  }

  /// Every kind of object, by its kind.
  void list(std::string_view name, const std::vector<Object>&, const Limits& count) {
    const Json& schema = member(name);
    counted(schema, count);
    const Json& alternatives = schema["items"]["oneOf"];
    expect(alternatives.size() == shape_kinds().size(), "oneOf");
    for (std::size_t kind = 0; kind < shape_kinds().size(); ++kind) {
      for (const Json& reference : alternatives) {
        const Json& alternative = resolved(reference);
        if (alternative["properties"]["kind"]["const"] != std::string(shape_kinds()[kind].id)) continue;
        const Object item{"object", "Object", make_shape(static_cast<ShapeKind>(kind))};
        object(alternative, [&] { members(*this, item); });
        ++shapes_;
      }
    }
  }

  void points(std::string_view name, const std::vector<Eigen::Vector3d>&, const Limits& count) {
    const Json& schema = member(name);
    counted(schema, count);
    const Json point = resolved(schema.value("items", Json::object()));
    numbers(point, 3, limits::coordinate);
  }
  void numbers(std::string_view name, const std::vector<double>&, const Limits& count) {
    const Json& schema = member(name);
    counted(schema, count);
    numeric(schema.value("items", Json::object()), "number", limits::coordinate);
  }

  void net(std::string_view name, const Net&, const Limits& count) {
    const Json& schema = member(name);
    counted(schema, count);
    const Json row = schema.value("items", Json::object());
    counted(row, count);
    numbers(resolved(row.value("items", Json::object())), 3, limits::coordinate);
  }

  void patches(std::string_view name, const std::map<PatchIndex, PatchEdit>&, const Limits& count) {
    const Json& schema = member(name);
    counted(schema, count);
    const int i = 0, j = 0;
    const PatchEdit edit;
    object(resolved(schema["items"]), [&] { members(*this, i, j, edit); });
  }

  int compared() const { return compared_; }
  int models() const { return models_; }
  std::size_t shapes() const { return shapes_; }
  int curves() const { return curves_; }
  const std::string& differences() const { return differences_; }

 private:
  const Json& resolved(const Json& schema) const {
    if (!schema.contains("$ref")) return schema;
    return root_.at(Json::json_pointer(schema["$ref"].get<std::string>().substr(1)));
  }

  const Json& member(std::string_view name) {
    names_.insert(std::string(name));
    last_ = name;
    static const Json nothing = Json::object();
    if (!schema_->contains("properties") || !(*schema_)["properties"].contains(last_)) return nothing;
    return resolved((*schema_)["properties"][last_]);
  }

  void expect(bool same, const std::string& what) {
    ++compared_;
    if (!same) differences_ += last_ + ": " + what + "\n";
  }
  void equal(const Json& schema, const char* key, const Json& value) {
    expect(schema.contains(key) && schema[key] == value, key);
  }
  void numeric(const Json& schema, const char* type, const Limits& range) {
    equal(schema, "type", type);
    equal(schema, "minimum", range.min);
    equal(schema, "maximum", range.max);
  }
  void counted(const Json& schema, const Limits& count) {
    equal(schema, "type", "array");
    equal(schema, "minItems", count.min);
    equal(schema, "maxItems", count.max);
  }
  void numbers(const Json& schema, int count, const Limits& range) {
    counted(schema, {static_cast<double>(count), static_cast<double>(count)});
    if (schema.contains("items")) numeric(schema["items"], "number", range);
  }

  const Json& root_;
  const Json* schema_;
  std::set<std::string> names_;
  std::set<std::string> later_;  ///< not in older documents
  std::string last_, differences_;
  int compared_ = 0, models_ = 0, curves_ = 0;
  std::size_t shapes_ = 0;
};

Json load_schema() {
  std::ifstream file(std::string(KNOTWORK_SCENE_DIR) + "/document.schema.json");
  return Json::parse(file, nullptr, false);
}

std::string differences(const Json& schema) {
  SchemaComparison comparison(schema, schema);
  const Document document;
  comparison.object(schema, [&] { members(comparison, document); });
  return comparison.differences();
}

}  // namespace

TEST_CASE("document schema: members, limits and choices are those of the code") {
  const Json schema = load_schema();
  REQUIRE(schema.is_object());
  SchemaComparison comparison(schema, schema);
  const Document document;
  comparison.object(schema, [&] { members(comparison, document); });
  CHECK(comparison.differences() == "");
  CHECK(comparison.models() == 2 * static_cast<int>(model_kinds().size()));
  CHECK(comparison.shapes() == shape_kinds().size());
  CHECK(comparison.curves() == 2 * 17);  // alone, and under a blending curve
  CHECK(comparison.compared() > 150);
}

TEST_CASE("document schema: the comparison sees a wrong limit, a wrong choice and a forgotten member") {
  const Json schema = load_schema();
  REQUIRE(schema.is_object());
  Json wrong = schema;
  wrong["$defs"]["camera"]["properties"]["elevation"]["maximum"] = 1.6;
  CHECK(differences(wrong) == "elevation: maximum\n");
  wrong = schema;
  wrong["$defs"]["animation"]["properties"]["motion"]["enum"][1] = "waltz";
  CHECK(differences(wrong) == "motion: enum\n");
  wrong = schema;
  wrong["$defs"]["display"]["properties"].erase("frames");
  CHECK_FALSE(differences(wrong).empty());
  wrong = schema;
  wrong["$defs"]["patch"]["properties"]["shear"] = {{"type", "number"}};
  CHECK_FALSE(differences(wrong).empty());
}

}  // namespace knotwork::scene::document_schema_test
