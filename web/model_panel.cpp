#include "web/model_panel.h"

#include <array>

#include "knotwork/surface/surface_measures.h"

namespace knotwork::web {

/// "closed × twisted", u first.
Sentence size_text(const Frame&, const ModelSurfaceFigure& figure) {
  constexpr std::array<std::string_view, 3> words{"open", "closed", "twisted"};
  const SurfaceDomain where = domain(figure.shown.model());
  return say("{} × {}", say(words[static_cast<std::size_t>(where.closure_u)]),
             say(words[static_cast<std::size_t>(where.closure_v)]));
}

void draw_readout(Frame& frame, float left, float y, const ModelSurfaceFigure& figure) {
  if (!frame.input.pointed) return;
  const glm::dvec2 place = *frame.input.pointed;
  const SurfaceJet jet = figure.shown.evaluate(place.x, place.y);
  place_readout(frame, left, y, {place.x, place.y, jet.s, curvature(jet)}, 0);
}

}  // namespace knotwork::web
