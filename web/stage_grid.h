#pragma once

#include <optional>

#include "knotwork/later.h"
#include "knotwork/mesh/surface_sampling.h"
#include "web/camera.h"
#include "web/figure.h"

namespace knotwork::web {

/// Which grid the surface on the stage is drawn on: with as many samples as its document says, or with as many steps as
/// keep its triangles within half a CSS pixel of it on this very screen (fitted_grid.h). Fitted steps are chosen anew
/// when the surface or the view has changed, and taken over when they are finer somewhere or half as many do; while a hand
/// or the clock is at work four times a second at most, and only finer ones.
class StageGrid {
 public:
  /// About as many vertices are spent on a close look, and so much farther than half a pixel may triangles then stray.
  static constexpr int most_vertices = 200000;

  struct Look {
    const Figure& figure;  ///< a surface
    int samples_u, samples_v;
    bool fitted;  ///< to the screen
    const View& view;
    bool other_grid;  ///< the tables that are there are not this surface's
    bool changed;     ///< since the last look
    bool busy;
    double now;  ///< milliseconds
  };

  /// Whether tables have to be made for grid().
  bool choose(const Look& look);
  /// parted: with the values of both sides at knot lines (parted_at_knots).
  SampleGrid grid(const Figure& figure, bool parted = false) const;
  /// Whether the last look was put off.
  bool wants_another_look() const { return put_off_; }
  /// Fitting belongs to a later part of the module: nothing is fitted before that is here.
  void allow_fitting() { may_fit_ = true; }

 private:
  KNOTWORK_LATER bool fit(const Look& look);

  GridSteps steps_;
  bool may_fit_ = false, fitted_ = false, put_off_ = false;
  bool kept_ = false;  ///< coarser steps might do
  std::optional<View> fitted_view_;
  double fitted_at_ = 0;
};

/// Steps that keep the triangles of the surface within half a CSS pixel of it where they can be seen.
KNOTWORK_LATER GridSteps steps_on_screen(const Figure& figure, const View& view);

}  // namespace knotwork::web
