#include "knotwork/scene/curve_sampling.h"

#include <algorithm>

#include <doctest/doctest.h>

namespace knotwork::scene::curve_sampling_test {

TEST_CASE("curve sampling: even steps on a straight line, more where it bends") {
  const CatalogueCurve line = make_catalogue_curve("line").value();
  const CurveView straight = view_of(line);
  CHECK(drawing_parameters(straight, 0, 1, 8, 1e-6) ==
        std::vector<double>{0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1});
  const CatalogueCurve circle = make_catalogue_curve("circle").value();
  const CurveView round = view_of(circle);
  const std::vector<double> few = drawing_parameters(round, 0, 3, 8, 1e-2),
                            many = drawing_parameters(round, 0, 3, 8, 1e-4);
  CHECK(few.size() < many.size());
  CHECK(many.front() == 0);
  CHECK(many.back() == 3);
  CHECK(std::is_sorted(many.begin(), many.end()));
  // Not even a tolerance of nothing goes on for ever.
  CHECK(drawing_parameters(round, 0, 3, 8, 0).size() == 8 * 32 + 1);
  CHECK(drawn_size(round) == doctest::Approx(std::sqrt(2.0)));
}

TEST_CASE("curve sampling: steps follow the turns of the parameter, within bounds") {
  CHECK(least_steps(make_catalogue_curve("circle").value()) == 256);
  CHECK(least_steps(make_catalogue_curve("line").value()) == 256);
  CHECK(least_steps(make_catalogue_curve("butterfly").value()) == 12 * 256);
  const double measures[] = {1, 0.1, 1e6};
  CHECK(least_steps(make_catalogue_curve("helix", measures).value()) == 6144);
}

}  // namespace knotwork::scene::curve_sampling_test
