#include <cmath>
#include <set>

#include "knotwork/scene/blending_curve_edits.h"
#include "knotwork/scene/curve_edits.h"
#include "knotwork/scene/document.h"
#include "knotwork/scene/document_members.h"
#include "knotwork/scene/fit_edits.h"
#include "knotwork/scene/messages.h"
#include "knotwork/scene/net_edits.h"
#include "knotwork/scene/subdivision_edits.h"

namespace knotwork::scene {

namespace {

/// Rotations this close to unit length count as unit: an edit written with few digits must stay readable.
constexpr double unit_tolerance = 1e-6;

/// Looks at every member of a document and remembers the first that is outside its limits.
class Checker {
 public:
  static constexpr bool reads = false;

  void constant(std::string_view, std::string_view) {}
  void constant(std::string_view, int) {}
  void toggle(std::string_view, bool) {}
  void later_toggle(std::string_view, bool) {}
  template <class E>
  void later_choice(std::string_view name, E value) {
    choice(name, value);
  }
  void later_points(std::string_view name, const std::vector<Eigen::Vector3d>& list, const Limits& count) {
    points(name, list, count);
  }

  void text(std::string_view name, const std::string& value, const Limits& length, bool slug) {
    std::size_t characters = 0;
    bool slug_so_far = true;
    for (char c : value) {
      const bool letter = c >= 'a' && c <= 'z';
      if (!letter && (characters == 0 || !((c >= '0' && c <= '9') || c == '-'))) slug_so_far = false;
      // A byte 10xxxxxx continues a character of UTF-8.
      if ((static_cast<unsigned char>(c) & 0xC0u) != 0x80u) ++characters;
    }
    if (!length.contains(static_cast<double>(characters))) {
      fail(name, "Must have from " + number_text(length.min) + " to " + number_text(length.max) + " characters.");
    } else if (slug && !slug_so_far) {
      fail(name, "Must begin with a letter from a to z and go on with such letters, digits and hyphens.");
    }
  }

  void number(std::string_view name, double value, const Limits& range) {
    if (!range.contains(value)) fail(name, number_message(range));
  }

  void integer(std::string_view name, int value, const Limits& range) {
    if (!range.contains(value)) fail(name, integer_message(range));
  }

  template <class E>
  void choice(std::string_view name, E value) {
    if (static_cast<int>(value) >= ids_of(value).count) fail(name, "Is none of the known choices.");
  }

  void vector(std::string_view name, const Eigen::Vector3d& v, const Limits& range) {
    for (int k = 0; k < 3; ++k) {
      if (!range.contains(v[k])) fail(element(name, k), number_message(range));
    }
  }

  void quaternion(std::string_view name, const Eigen::Quaterniond& q, const Limits& range) {
    for (int k = 0; k < 4; ++k) {
      if (!range.contains(q.coeffs()[k])) fail(element(name, k), number_message(range));
    }
    // Only now is the length known to be a number.
    if (ok() && std::abs(q.norm() - 1) > unit_tolerance) fail(name, "Must be a quaternion of length 1.");
  }

  template <class F>
  void group(std::string_view name, F visit) {
    const std::size_t outer = path_.size();
    enter(name);
    visit();
    path_.resize(outer);
  }

  template <class T>
  void list(std::string_view name, const std::vector<T>& items, const Limits& count) {
    if (!count.contains(static_cast<double>(items.size()))) fail(name, count_message(count));
    int index = 0;
    for (const T& item : items) group(element(name, index++), [&] { members(*this, item); });
  }

  void points(std::string_view name, const std::vector<Eigen::Vector3d>& points, const Limits& count) {
    if (!count.contains(static_cast<double>(points.size()))) fail(name, count_message(count));
    point_count_ += points.size();
    if (point_count_ > max_document_points)
      fail(name, "All curves together must have at most " + std::to_string(max_document_points) + " points.");
    int index = 0;
    for (const Eigen::Vector3d& point : points) vector(element(name, index++), point, limits::coordinate);
  }

  void numbers(std::string_view name, const std::vector<double>& values, const Limits& count) {
    if (!count.contains(static_cast<double>(values.size()))) fail(name, count_message(count));
    int index = 0;
    for (const double value : values) number(element(name, index++), value, limits::coordinate);
  }

  void net(std::string_view name, const Net& net, const Limits& count) {
    if (!count.contains(static_cast<double>(net.size()))) fail(name, count_message(count));
    int index = 0;
    for (const std::vector<Eigen::Vector3d>& row : net) {
      const std::string place = element(name, index++);
      if (row.size() != net.front().size())
        fail(place, "Must hold as many points as the first row: " + std::to_string(net.front().size()) + ".");
      points(place, row, count);
    }
  }

  void patches(std::string_view name, const std::map<PatchIndex, PatchEdit>& edits, const Limits& count) {
    patch_count_ += edits.size();
    if (!count.contains(static_cast<double>(patch_count_))) fail(name, count_message(count));
    int index = 0;
    for (const auto& [patch, edit] : edits) {
      const std::size_t outer = path_.size();
      enter(element(name, index++));
      members(*this, patch.first, patch.second, edit);
      path_.resize(outer);
    }
  }

  void fail(std::string_view name, std::string message) {
    if (!ok()) return;
    const std::size_t outer = path_.size();
    enter(name);
    error_ = {path_, std::move(message)};
    path_.resize(outer);
  }

  bool ok() const { return error_.message.empty(); }
  Status status() const { return ok() ? success() : Status(error_); }

  static std::string element(std::string_view name, int index) {
    return std::string(name) + '[' + std::to_string(index) + ']';
  }

 private:
  void enter(std::string_view name) {
    if (!path_.empty()) path_ += '.';
    path_ += name;
  }

  static std::string count_message(const Limits& count) {
    return "Must hold from " + number_text(count.min) + " to " + number_text(count.max) + " elements.";
  }

  std::string path_;
  Error error_;
  // Over all objects, so that what is written can be read again.
  std::size_t patch_count_ = 0, point_count_ = 0;
};

/// The parameter of a B-function within its family's limits.
void check_blending(Checker& checker, BlendingKind kind, int parameter) {
  const BlendingFamily& family = blending_family(kind);
  const Limits range{static_cast<double>(family.parameter_min), static_cast<double>(family.parameter_max)};
  if (range.max > 0 && !range.contains(parameter)) checker.fail("blending.parameter", integer_message(range));
}

/// What no single member's limits can say.
void check_together(Checker& checker, const BlendingSurfaceObject& object) {
  if (const Status model = validate(object.model); !model) {
    checker.fail("model." + model.error().path, model.error().message);
  }
  const auto refuse_closed = [&](std::string_view direction) {
    checker.fail("topology." + std::string(direction), "The " + std::string(model_name(object.model)) +
                                                           " is not closed in " + std::string(direction) +
                                                           ", so this direction can only be open.");
  };
  if (object.topology_u == Topology::closed && !closes_u(object.model)) refuse_closed("u");
  if (object.topology_v == Topology::closed && !closes_v(object.model)) refuse_closed("v");

  if (checker.ok()) {
    if (const SeamProblem seam = seam_problem(object); !seam.message.empty()) checker.fail(seam.member, seam.message);
  }
  check_blending(checker, object.blending, object.blending_parameter);
}

void check_together(Checker&, const BezierCurveObject&) {}

void check_together(Checker& checker, const BSplineCurveObject& object) {
  if (const Result<BSplineCurve> curve = build_curve(object); !curve)
    checker.fail(curve.error().path, curve.error().message);
}

void check_together(Checker& checker, const FittedCurveObject& object) {
  if (const Status fit = check_fit(object); !fit) checker.fail(fit.error().path, fit.error().message);
}

void check_together(Checker& checker, const SubdivisionCurveObject& object) {
  if (const Status walk = check_subdivision(object); !walk) checker.fail(walk.error().path, walk.error().message);
}

void check_together(Checker& checker, const ModelCurveObject& object) {
  if (const Status model = check_model(object.model); !model) checker.fail(model.error().path, model.error().message);
}

void check_together(Checker& checker, const BlendingCurveObject& object) {
  check_blending(checker, object.blending, object.blending_parameter);
  // The curve can be built only from a B-function that there is.
  if (!checker.ok()) return;
  if (const Status curve = check_curve(object); !curve) checker.fail(curve.error().path, curve.error().message);
}

void check_together(Checker& checker, const ModelSurfaceObject& object) {
  if (model_kind(object.model) == ModelKind::sheet) {
    checker.fail("model.kind", std::string(sheet_alone));
  } else if (const Status model = validate(object.model); !model) {
    checker.fail("model." + model.error().path, model.error().message);
  }
}

void check_together(Checker& checker, const BSplineSurfaceObject& object) {
  if (const Result<BSplineSurface> surface = build_net(object); !surface)
    checker.fail(surface.error().path, surface.error().message);
}

}  // namespace

Status check(const Document& document) {
  Checker checker;
  members(checker, document);
  // The checks below look members up by value: they need the ones above to have passed.
  if (!checker.ok()) return checker.status();

  std::set<std::string_view> ids;
  int index = 0;
  for (const Object& object : document.objects) {
    checker.group(Checker::element("objects", index++), [&] {
      if (!ids.insert(object.id).second) checker.fail("id", "Must be another than the other objects' ids.");
      visit_first([&](const auto& shape) { check_together(checker, shape); }, object.shape);
    });
  }
  return checker.status();
}

Status check(const PatchEdit& edit) {
  Checker checker;
  members(checker, edit);
  return checker.status();
}

Status check(const Camera& camera) {
  Checker checker;
  members(checker, camera);
  return checker.status();
}

}  // namespace knotwork::scene
