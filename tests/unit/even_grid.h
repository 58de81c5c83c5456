#pragma once

#include "knotwork/mesh/surface_sampling.h"

namespace knotwork::test {

/// The grid that a surface is drawn on with about so many steps.
template <class Surface>
SampleGrid grid_of(const Surface& surface, int samples_u, int samples_v) {
  return sample_grid(surface.knots_u(), surface.knots_v(), samples_u, samples_v, Seam::repeated);
}

}  // namespace knotwork::test
