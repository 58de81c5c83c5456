#include "knotwork/surface/model_surface.h"

#include <cassert>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "knotwork/surface/sheet_formula.h"

namespace knotwork {
namespace {

using std::numbers::pi;
/// Bound on lengths and coordinates of a model, so that nothing computed from them overflows.
constexpr double largest_length = 1e6, smallest_length = 1e-6;

/// Finite first: comparing a NaN is itself a floating-point exception, and tests trap those.
bool within(double x, double least, double greatest) { return std::isfinite(x) && x >= least && x <= greatest; }

SurfaceJet sheet_jet(const Sheet& sheet, double u, double v) {
  return jet(sheet_formula(sheet, Taylor2::variable_u(u), Taylor2::variable_v(v)));
}

SurfaceDomain domain_of(const Sheet& m) {
  const auto closure = [](double bend) { return bend == 1 ? Closure::closed : Closure::open; };
  return {{-pi, pi}, {-pi, pi}, closure(m.bend_u), closure(m.bend_v)};
}

struct NamedLength {
  const char* name;
  double value;
};
Status check_lengths(std::initializer_list<NamedLength> lengths) {
  for (const NamedLength& length : lengths) {
    if (!within(length.value, smallest_length, largest_length)) {
      return Error{length.name, "This length must be a positive number between 0.000001 and 1000000."};
    }
  }
  return success();
}

Status check(const Sheet& m) {
  if (!within(m.bend_u, 0, 1)) return Error{"bend_u", "A bend must lie between 0 (flat) and 1 (closed)."};
  if (!within(m.bend_v, 0, 1)) return Error{"bend_v", "A bend must lie between 0 (flat) and 1 (closed)."};
  return check_lengths({{"flat_radius_u", m.flat_radius_u},
                        {"closed_radius_u", m.closed_radius_u},
                        {"flat_radius_v", m.flat_radius_v},
                        {"closed_radius_v", m.closed_radius_v}});
}

}  // namespace

// A catalogue surface is the other alternative: none of its code is on the sheet's way.

SurfaceDomain domain(const ModelSurface& model) {
  const Sheet* sheet = std::get_if<Sheet>(&model);
  return sheet != nullptr ? domain_of(*sheet) : domain(*std::get_if<CatalogueSurface>(&model));
}

std::string_view model_name(const ModelSurface& model) {
  const CatalogueSurface* surface = std::get_if<CatalogueSurface>(&model);
  return surface == nullptr ? "sheet" : surface_catalogue()[static_cast<std::size_t>(surface->row)].name;
}

Status validate(const ModelSurface& model) {
  const Sheet* sheet = std::get_if<Sheet>(&model);
  return sheet != nullptr ? check(*sheet) : validate(*std::get_if<CatalogueSurface>(&model));
}

SurfaceJet evaluate(const ModelSurface& model, double u, double v) {
  const Sheet* sheet = std::get_if<Sheet>(&model);
  return sheet != nullptr ? sheet_jet(*sheet, u, v) : evaluate(*std::get_if<CatalogueSurface>(&model), u, v);
}

void evaluate_grid(const ModelSurface& model, std::span<const double> u, std::span<const double> v,
                   std::span<SurfaceJet> out) {
  assert(out.size() == u.size() * v.size());
  const Sheet* sheet = std::get_if<Sheet>(&model);
  if (sheet == nullptr) return evaluate_grid(*std::get_if<CatalogueSurface>(&model), u, v, out);
  std::size_t k = 0;
  for (const double a : u) {
    for (const double b : v) out[k++] = sheet_jet(*sheet, a, b);
  }
}

}  // namespace knotwork
