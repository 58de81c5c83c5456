#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "knotwork/surface/model_surface.h"

namespace knotwork::scene {

/// What carries a blending surface: the sheet, which follows the topology (plane, cylinder, torus), or 1 + the row of a
/// surface of the catalogue, a fixed shape.
enum class ModelKind : unsigned char { sheet };

/// One row of the table of models that parameters and documents iterate: the sheet and then the whole catalogue.
struct ModelRow {
  ModelKind kind;
  std::string_view id;     ///< in documents, as `sheet`
  std::string_view label;  ///< for readers
};
std::span<const ModelRow> model_kinds();
const ModelRow& model_row(ModelKind kind);
ModelKind model_kind(const ModelSurface& model);
/// The model of this kind with its standard measures.
ModelSurface make_model(ModelKind kind);

/// The numbers that shape a model of this kind: a sheet's radii, or those of the catalogue's row.
std::span<const CatalogueMeasure> model_measures(ModelKind kind);
/// The value of measure k of the model.
double& model_measure(ModelSurface& model, std::size_t k);
double model_measure(const ModelSurface& model, std::size_t k);

/// Why the sheet cannot stand by itself.
inline constexpr std::string_view sheet_alone =
    "The rolling sheet follows a topology, which a model alone does not have.";

/// Whether the model can be closed in the direction: a sheet always, as it rolls; the others where they are periodic,
/// with or without a twist.
bool closes_u(const ModelSurface& model);
bool closes_v(const ModelSurface& model);

}  // namespace knotwork::scene
