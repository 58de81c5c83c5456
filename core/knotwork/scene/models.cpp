#include "knotwork/scene/models.h"

#include <vector>

namespace knotwork::scene {

namespace {

/// In the order of sheet_members.
constexpr CatalogueMeasure sheet_measures[] = {
    length_measure("flatRadiusU", "Flat radius u", Sheet{}.flat_radius_u),
    length_measure("closedRadiusU", "Closed radius u", Sheet{}.closed_radius_u),
    length_measure("flatRadiusV", "Flat radius v", Sheet{}.flat_radius_v),
    length_measure("closedRadiusV", "Closed radius v", Sheet{}.closed_radius_v)};
constexpr double Sheet::*sheet_members[] = {&Sheet::flat_radius_u, &Sheet::closed_radius_u, &Sheet::flat_radius_v,
                                            &Sheet::closed_radius_v};
static_assert(std::size(sheet_measures) == std::size(sheet_members));

int catalogue_row(ModelKind kind) { return static_cast<int>(kind) - 1; }

ModelKind kind_of_row(int row) { return static_cast<ModelKind>(row + 1); }

std::vector<ModelRow> make_model_table() {
  std::vector<ModelRow> table{{ModelKind::sheet, "sheet", "Rolling sheet"}};
  for (const CatalogueSurfaceRow& row : surface_catalogue()) {
    table.push_back({kind_of_row(static_cast<int>(table.size()) - 1), row.id, row.label});
  }
  return table;
}

}  // namespace

std::span<const ModelRow> model_kinds() {
  static const std::vector<ModelRow> table = make_model_table();
  return table;
}

const ModelRow& model_row(ModelKind kind) { return model_kinds()[static_cast<std::size_t>(kind)]; }

ModelKind model_kind(const ModelSurface& model) {
  const CatalogueSurface* surface = std::get_if<CatalogueSurface>(&model);
  return surface == nullptr ? ModelKind::sheet : kind_of_row(surface->row);
}

ModelSurface make_model(ModelKind kind) {
  if (kind == ModelKind::sheet) return Sheet{};
  CatalogueSurface surface{catalogue_row(kind)};
  for (std::size_t k = 0; const CatalogueMeasure& measure : model_measures(kind)) {
    surface.measures[k++] = measure.standard;
  }
  return surface;
}

std::span<const CatalogueMeasure> model_measures(ModelKind kind) {
  if (kind == ModelKind::sheet) return sheet_measures;
  return surface_catalogue()[static_cast<std::size_t>(catalogue_row(kind))].measures;
}

double& model_measure(ModelSurface& model, std::size_t k) {
  Sheet* sheet = std::get_if<Sheet>(&model);
  return sheet != nullptr ? sheet->*sheet_members[k] : std::get_if<CatalogueSurface>(&model)->measures[k];
}

double model_measure(const ModelSurface& model, std::size_t k) {
  const Sheet* sheet = std::get_if<Sheet>(&model);
  return sheet != nullptr ? sheet->*sheet_members[k] : std::get_if<CatalogueSurface>(&model)->measures[k];
}

bool closes_u(const ModelSurface& model) {
  return model_kind(model) == ModelKind::sheet || domain(model).closure_u != Closure::open;
}

bool closes_v(const ModelSurface& model) {
  return model_kind(model) == ModelKind::sheet || domain(model).closure_v != Closure::open;
}

}  // namespace knotwork::scene
