#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "web/camera.h"
#include "web/figure.h"
#include "web/theme.h"

namespace knotwork::web {

/// A piece of a surface in a still picture.
struct Facet {
  std::vector<glm::dvec2> corners;  ///< CSS pixels, in order round the piece
  double depth;                     ///< of its middle before the eye, along the view, model units
  Colour colour;
};

/// A piece of a knot line.
struct FacetEdge {
  glm::dvec2 start, end;  ///< CSS pixels
  glm::dvec3 middle;      ///< in model space
};

struct SurfacePieces {
  std::vector<Facet> facets;
  std::vector<FacetEdge> knot_lines;
};

/// The figure's surface cut into about pieces_u x pieces_v flat pieces, at least one in each knot interval, lit as
/// shaders/surface.frag lights it in the light scheme. Pieces that reach behind the eye are left out, and of a surface
/// that is closed both ways those that face away. Empty for a curve.
/// Where stripes are shown, pieces are cut along their edges.
/// Preconditions: the figure is the document's; pieces_u, pieces_v >= 1.
SurfacePieces surface_pieces(const Figure& figure, const scene::Document& document, const View& view, int pieces_u,
                             int pieces_v);

}  // namespace knotwork::web
