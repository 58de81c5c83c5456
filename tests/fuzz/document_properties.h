#pragma once

#include <cmath>
#include <string_view>
#include <variant>

#include "knotwork/scene/curve_figure.h"
#include "knotwork/scene/document_json.h"
#include "knotwork/scene/surface_builder.h"

namespace knotwork::test {

/// What must hold for any bytes: parsing ends with an error that says something, or with a document that is valid,
/// comes back the same from its own text and makes a surface or a curve of numbers. True when it does.
inline bool text_is_handled(std::string_view text, bool& accepted) {
  const Result<scene::Document> result = scene::parse_document(text);
  accepted = result.has_value();
  if (!accepted) return !result.error().message.empty();
  const scene::Document& document = result.value();
  if (!scene::check(document)) return false;
  const Result<scene::Document> again = scene::parse_document(scene::write_document(document));
  if (!again || !(again.value() == document)) return false;
  const scene::Shape& shape = scene::stage_shape(document);
  const auto* object = std::get_if<scene::BlendingSurfaceObject>(&shape);
  if (object == nullptr) return scene::spline_of(shape)(0.3).allFinite();
  const BlendingSurface surface = scene::build_surface(*object, document.animation);
  const double u = surface.knots_u().start() + 0.3 * surface.knots_u().period();
  const double v = surface.knots_v().start() + 0.7 * surface.knots_v().period();
  return surface.evaluate(u, v).s.allFinite();
}

}  // namespace knotwork::test
