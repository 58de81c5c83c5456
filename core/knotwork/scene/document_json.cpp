#include "knotwork/scene/document_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "knotwork/scene/document_members.h"
#include "knotwork/scene/messages.h"

namespace knotwork::scene {

namespace {

using Json = nlohmann::ordered_json;

/// More than any document has; they keep junk from costing time and memory.
constexpr std::size_t max_depth = 16, max_members = 64, max_values = 1u << 19;

/// The most elements of a list, by the member it stands in; data to be fitted are the one list longer than the patches.
std::size_t max_elements(std::string_view member) {
  return static_cast<std::size_t>(member == "points" ? limits::data_points.max : limits::patches.max);
}

std::string joined(const std::string& path, std::string_view name) {
  if (name.empty()) return path;
  return path.empty() ? std::string(name) : path + '.' + std::string(name);
}

std::string element(std::string_view name, std::size_t index) {
  return std::string(name) + '[' + std::to_string(index) + ']';
}

/// Builds the value from the parser's events. The library's own builder lets the last of two equal keys win, goes as
/// deep as the text does and forgets where a number was that no double holds.
class TreeBuilder : public nlohmann::json_sax<Json> {
 public:
  explicit TreeBuilder(std::string_view text) : text_(text) {}

  Json& root() { return root_; }
  const Error& error() const { return error_; }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(Json::number_integer_t value) override { return add(value); }
  bool number_unsigned(Json::number_unsigned_t value) override { return add(value); }
  bool number_float(Json::number_float_t value, const std::string&) override { return add(value); }
  bool string(std::string& value) override { return add(std::move(value)); }
  bool binary(Json::binary_t&) override { return fail("Is not JSON."); }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_array() override { return close(); }

  bool key(std::string& name) override {
    Level& level = levels_.back();
    level.key = std::move(name);
    if (level.node->contains(level.key)) return fail("Is given twice.");
    if (level.node->size() >= max_members) return fail("Is in an object with more members than any in a document.");
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception& reason) override {
    // 406 of the library: a number that overflows.
    if (reason.id == 406) return fail("Is a number too large to be stored: " + token.substr(0, 40) + ".");
    const std::string_view before = text_.substr(0, std::min(position, text_.size()));
    std::size_t line = 1, column = 1;
    for (char c : before.substr(0, before.empty() ? 0 : before.size() - 1)) {
      line = c == '\n' ? line + 1 : line;
      column = c == '\n' ? 1 : column + 1;
    }
    return fail("The text is not JSON: what is at line " + std::to_string(line) + ", column " + std::to_string(column) +
                " does not belong there.");
  }

 private:
  struct Level {
    Json* node;
    std::string key;
  };

  bool fail(std::string message) {
    error_ = {path(), std::move(message)};
    return false;
  }

  std::string path() const {
    std::string path;
    for (const Level& level : levels_) {
      // A list that holds the next level's value already counts it.
      const std::size_t counted = &level == &levels_.back() ? 0 : 1;
      path =
          level.node->is_array() ? element(path, level.node->size() - counted) : joined(path, level.key.substr(0, 80));
    }
    return path;
  }

  /// The place of the next value, nullptr when there is no room for it.
  Json* place(Json value) {
    if (++values_ > max_values) return fail("There are more values than in any document."), nullptr;
    if (levels_.empty()) return &(root_ = std::move(value));
    Level& level = levels_.back();
    if (level.node->is_object()) return &((*level.node)[level.key] = std::move(value));
    const std::string_view member = levels_.size() < 2 ? std::string_view{} : levels_[levels_.size() - 2].key;
    if (level.node->size() >= max_elements(member)) return fail("Is in a longer list than any in a document."), nullptr;
    level.node->push_back(std::move(value));
    return &level.node->back();
  }

  bool add(Json value) { return place(std::move(value)) != nullptr; }

  bool open(Json value) {
    if (levels_.size() >= max_depth) return fail("Is nested deeper than anything in a document.");
    Json* node = place(std::move(value));
    if (node == nullptr) return false;
    // The outer levels' pointers stay good: only the innermost container grows.
    levels_.push_back({node, {}});
    return true;
  }

  bool close() {
    levels_.pop_back();
    return true;
  }

  std::string_view text_;
  Json root_;
  std::vector<Level> levels_;
  Error error_;
  std::size_t values_ = 0;
};

/// Fills a document from a JSON value; remembers the first member that is missing, unknown or of a wrong type. Limits
/// are the checks' matter, but for integers, which must fit into an int first.
class Reader {
 public:
  static constexpr bool reads = true;

  template <class T>
  void read(const Json& node, T& value) {
    object(node, [&] { members(*this, value); });
  }

  const Error& error() const { return error_; }
  bool ok() const { return error_.message.empty(); }

  void constant(std::string_view name, std::string_view expected) {
    const Json* node = member(name);
    if (node == nullptr) return;
    const std::string* value = node->get_ptr<const Json::string_t*>();
    if (value == nullptr || *value != expected) fail(name, "Must be \"" + std::string(expected) + "\".");
  }

  void constant(std::string_view name, int expected) {
    const std::optional<double> value = number_in(member(name), name, "Must be a whole number.");
    if (value && *value != expected) {
      fail(name, "Must be " + std::to_string(expected) + ", the only one that can be read here, not " +
                     number_text(*value) + ".");
    }
  }

  void text(std::string_view name, std::string& value, const Limits&, bool) {
    const Json* node = member(name);
    if (node == nullptr) return;
    if (const std::string* string = node->get_ptr<const Json::string_t*>()) {
      value = *string;
    } else {
      fail(name, "Must be text.");
    }
  }

  void number(std::string_view name, double& value, const Limits& range) {
    read_number(member(name), name, value, range);
  }

  void integer(std::string_view name, int& value, const Limits& range) {
    const std::optional<double> number = number_in(member(name), name, integer_message(range));
    if (!number) return;
    if (!range.contains(*number) || *number != std::floor(*number)) return fail(name, integer_message(range));
    value = static_cast<int>(*number);
  }

  /// Of a member that older documents do not have: absent, the value stays.
  void later_toggle(std::string_view name, bool& value) {
    if (ok() && node_->contains(name)) toggle(name, value);
  }
  template <class E>
  void later_choice(std::string_view name, E& value) {
    if (ok() && node_->contains(name)) choice(name, value);
  }
  void later_points(std::string_view name, std::vector<Eigen::Vector3d>& points, const Limits& count) {
    if (ok() && node_->contains(name)) this->points(name, points, count);
  }
  void toggle(std::string_view name, bool& value) {
    const Json* node = member(name);
    if (node == nullptr) return;
    if (!node->is_boolean()) return fail(name, "Must be true or false.");
    value = node->get<bool>();
  }

  template <class E>
  void choice(std::string_view name, E& value) {
    const Json* node = member(name);
    if (node == nullptr) return;
    const ChoiceIds ids = ids_of(value);
    const std::string* id = node->get_ptr<const Json::string_t*>();
    const int index = id == nullptr ? -1 : find_choice(ids, *id);
    if (index < 0) return fail(name, choice_message(ids));
    value = static_cast<E>(index);
  }

  void vector(std::string_view name, Eigen::Vector3d& v, const Limits& range) {
    coordinates(member(name), name, v.data(), 3, range);
  }

  void quaternion(std::string_view name, Eigen::Quaterniond& q, const Limits& range) {
    coordinates(member(name), name, q.coeffs().data(), 4, range);
  }

  template <class F>
  void group(std::string_view name, F visit) {
    if (const Json* node = member(name)) inside(name, *node, visit);
  }

  template <class T>
  void list(std::string_view name, std::vector<T>& items, const Limits&) {
    const Json* node = array(name);
    if (node == nullptr) return;
    for (const Json& item : *node) {
      items.emplace_back();
      inside(element(name, items.size() - 1), item, [&] { members(*this, items.back()); });
      if (!ok()) return;
    }
  }

  void points(std::string_view name, std::vector<Eigen::Vector3d>& points, const Limits&) {
    read_points(member(name), name, points);
  }

  void numbers(std::string_view name, std::vector<double>& values, const Limits&) {
    const Json* node = array(name);
    if (node == nullptr) return;
    values.clear();
    for (const Json& item : *node) {
      values.emplace_back();
      read_number(&item, element(name, values.size() - 1), values.back(), limits::coordinate);
      if (!ok()) return;
    }
  }

  void net(std::string_view name, Net& net, const Limits&) {
    const Json* node = array(name);
    if (node == nullptr) return;
    net.clear();
    for (const Json& item : *node) {
      net.emplace_back();
      read_points(&item, element(name, net.size() - 1), net.back());
      if (!ok()) return;
    }
  }

  void patches(std::string_view name, std::map<PatchIndex, PatchEdit>& edits, const Limits&) {
    const Json* node = array(name);
    if (node == nullptr) return;
    for (const Json& item : *node) {
      PatchIndex patch;
      PatchEdit edit;
      const std::string place = element(name, edits.size());
      inside(place, item, [&] { members(*this, patch.first, patch.second, edit); });
      if (!ok()) return;
      if (!edits.emplace(patch, edit).second) return fail(place, "Is for the same patch as one before it.");
    }
  }

 private:
  void fail(std::string_view name, std::string message) {
    if (ok()) error_ = {joined(path_, name), std::move(message)};
  }

  /// nullptr when it is missing, which is then the error, and after any error.
  const Json* member(std::string_view name) {
    if (!ok()) return nullptr;
    seen_.push_back(name);
    for (const auto& [key, value] : node_->get_ref<const Json::object_t&>()) {
      if (key == name) return &value;
    }
    fail(name, "Is missing.");
    return nullptr;
  }

  const Json* array(std::string_view name) { return array(member(name), name); }

  const Json* array(const Json* node, std::string_view name) {
    if (node == nullptr || node->is_array()) return node;
    fail(name, "Must be a list.");
    return nullptr;
  }

  template <class F>
  void inside(std::string_view name, const Json& node, F visit) {
    const std::size_t outer = path_.size();
    path_ = joined(path_, name);
    object(node, visit);
    path_.resize(outer);
  }

  template <class F>
  void object(const Json& node, F visit) {
    if (!node.is_object()) return fail("", "Must be an object.");
    const Json* outer = std::exchange(node_, &node);
    std::vector<std::string_view> outer_seen = std::exchange(seen_, {});
    visit();
    for (const auto& [key, value] : node.get_ref<const Json::object_t&>()) {
      if (std::find(seen_.begin(), seen_.end(), key) == seen_.end()) {
        fail(key.substr(0, 80), "Is not a member that a document has here.");
      }
    }
    node_ = outer;
    seen_ = std::move(outer_seen);
  }

  std::optional<double> number_in(const Json* node, std::string_view name, std::string_view message) {
    if (node == nullptr) return std::nullopt;
    if (node->is_number()) return node->get<double>();
    fail(name, std::string(message));
    return std::nullopt;
  }

  void read_number(const Json* node, std::string_view name, double& value, const Limits& range) {
    if (const std::optional<double> number = number_in(node, name, number_message(range))) value = *number;
  }

  void read_points(const Json* list, std::string_view name, std::vector<Eigen::Vector3d>& points) {
    const Json* node = array(list, name);
    if (node == nullptr) return;
    points.clear();
    for (const Json& item : *node) {
      const std::string place = element(name, points.size());
      points.emplace_back();
      coordinates(&item, place, points.back().data(), 3, limits::coordinate);
      if (!ok()) return;
    }
  }

  /// `count` numbers in a list.
  void coordinates(const Json* list, std::string_view name, double* values, std::size_t count, const Limits& range) {
    const Json* node = array(list, name);
    if (node == nullptr) return;
    if (node->size() != count) return fail(name, "Must be a list of " + std::to_string(count) + " numbers.");
    std::size_t index = 0;
    for (const Json& item : *node) {
      read_number(&item, element(name, index), values[index], range);
      ++index;
    }
  }

  const Json* node_ = nullptr;
  std::vector<std::string_view> seen_;  ///< members of node_ that were asked for
  std::string path_;
  Error error_;
};

/// Writes members one after the other; only numbers and text need the library.
class Writer {
 public:
  static constexpr bool reads = false;

  template <class T>
  std::string write(const T& value) {
    object([&] { members(*this, value); });
    return std::move(text_);
  }

  void constant(std::string_view name, std::string_view value) { leaf(name, Json(value)); }
  void constant(std::string_view name, int value) { leaf(name, Json(value)); }
  void text(std::string_view name, const std::string& value, const Limits&, bool) { leaf(name, Json(value)); }
  void number(std::string_view name, double value, const Limits&) { leaf(name, Json(value)); }
  void integer(std::string_view name, int value, const Limits&) { leaf(name, Json(value)); }
  void toggle(std::string_view name, bool value) { leaf(name, Json(value)); }
  void later_toggle(std::string_view name, bool value) { toggle(name, value); }
  template <class E>
  void later_choice(std::string_view name, E value) {
    choice(name, value);
  }
  void later_points(std::string_view name, const std::vector<Eigen::Vector3d>& list, const Limits& count) {
    if (!list.empty()) points(name, list, count);
  }

  template <class E>
  void choice(std::string_view name, E value) {
    leaf(name, Json(id_of(value)));
  }

  void vector(std::string_view name, const Eigen::Vector3d& v, const Limits&) {
    begin(name);
    numbers({v.data(), 3});
  }
  void quaternion(std::string_view name, const Eigen::Quaterniond& q, const Limits&) {
    begin(name);
    numbers({q.coeffs().data(), 4});
  }
  void points(std::string_view name, const std::vector<Eigen::Vector3d>& list, const Limits&) {
    begin(name);
    points(list);
  }
  void net(std::string_view name, const Net& net, const Limits&) {
    begin(name);
    text_ += '[';
    for (const std::vector<Eigen::Vector3d>& row : net) {
      if (text_.back() != '[') text_ += ',';
      points(row);
    }
    text_ += ']';
  }
  void numbers(std::string_view name, const std::vector<double>& values, const Limits&) {
    begin(name);
    numbers(values);
  }

  template <class F>
  void group(std::string_view name, F visit) {
    begin(name);
    object(visit);
  }

  template <class T>
  void list(std::string_view name, const std::vector<T>& items, const Limits&) {
    array(name, items, [&](const T& item) { members(*this, item); });
  }

  void patches(std::string_view name, const std::map<PatchIndex, PatchEdit>& edits, const Limits&) {
    array(name, edits, [&](const auto& item) { members(*this, item.first.first, item.first.second, item.second); });
  }

 private:
  void begin(std::string_view name) {
    if (text_.back() != '{') text_ += ',';
    text_ += '"';
    text_ += name;
    text_ += "\":";
  }

  void value(const Json& json) { text_ += json.dump(-1, ' ', false, Json::error_handler_t::replace); }

  void leaf(std::string_view name, const Json& json) {
    begin(name);
    value(json);
  }

  template <class F>
  void object(F visit) {
    text_ += '{';
    visit();
    text_ += '}';
  }

  template <class Items, class F>
  void array(std::string_view name, const Items& items, F visit) {
    begin(name);
    text_ += '[';
    for (const auto& item : items) {
      if (text_.back() != '[') text_ += ',';
      object([&] { visit(item); });
    }
    text_ += ']';
  }

  void points(const std::vector<Eigen::Vector3d>& list) {
    text_ += '[';
    for (const Eigen::Vector3d& point : list) {
      if (text_.back() != '[') text_ += ',';
      numbers({point.data(), 3});
    }
    text_ += ']';
  }

  void numbers(std::span<const double> values) {
    text_ += '[';
    for (double x : values) {
      if (text_.back() != '[') text_ += ',';
      value(Json(x));
    }
    text_ += ']';
  }

  std::string text_;
};

}  // namespace

Result<Document> parse_document(std::string_view json) {
  if (json.size() > max_document_bytes) return Error{"", "The document is larger than 8 MiB."};

  TreeBuilder builder(json);
  if (!Json::sax_parse(json.data(), json.data() + json.size(), &builder)) return builder.error();

  Document document;
  Reader reader;
  reader.read(builder.root(), document);
  if (!reader.ok()) return reader.error();
  if (Status status = check(document); !status) return status.error();
  return document;
}

std::string write_document(const Document& document) { return Writer().write(document); }

}  // namespace knotwork::scene
