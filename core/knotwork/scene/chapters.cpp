#include "knotwork/scene/chapters.h"

#include <algorithm>

namespace knotwork::scene {

namespace {

/// A torus of 6 x 4 patches, one on the outer equator pulled outwards and turned a little, as one sees it when the
/// page opens: at the left, towards the reader.
Document blending_surface_start() {
  BlendingSurfaceObject surface;
  PatchEdit pulled;
  pulled.translation = {0, 0, 0.55};
  pulled.rotation = Eigen::AngleAxisd(0.3, Eigen::Vector3d(0.6, 0, 0.8));
  // Local (2, 2) is centred at u = -pi/3, v = 0 of the sheet.
  surface.edits[{2, 2}] = pulled;

  Document document;
  document.objects.push_back({"surface", "Blending surface", surface});
  document.camera.target = {0, 0, 0};
  document.camera.distance = 5.2;
  document.camera.azimuth = 0.2;
  document.camera.elevation = 0.55;
  return document;
}

}  // namespace

std::span<const Chapter> chapters() {
  static const std::vector<Chapter> table{
      {"blending-surface",
       "Blending surfaces",
       blending_surface_start,
       {"topology.u", "topology.v", "locals.u", "locals.v", "blending.function", "animation.playing"}},
  };
  return table;
}

const Chapter* find_chapter(std::string_view id) {
  const std::span<const Chapter> table = chapters();
  const auto found = std::find_if(table.begin(), table.end(), [&](const Chapter& row) { return row.id == id; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace knotwork::scene
