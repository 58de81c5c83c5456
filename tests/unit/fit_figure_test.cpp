#include "knotwork/scene/fit_figure.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/fit_edits.h"

namespace knotwork::scene::fit_figure_test {
namespace {

FittedCurveObject experiment(std::string_view chapter = "least-squares") {
  const Document document = find_chapter(chapter)->start_document();
  return *std::get_if<FittedCurveObject>(&stage_shape(document));
}

}  // namespace

TEST_CASE("fit figure: whiskers go from the data to the curve, their lengths make the errors") {
  for (const char* chapter : {"least-squares", "least-squares-closed"}) {
    const FittedCurveObject object = experiment(chapter);
    const FitFigure figure(object);
    REQUIRE(figure.feet.size() == 20);
    double squares = 0, maximum = 0;
    for (std::size_t j = 0; j < 20; ++j) {
      CHECK((figure.feet[j] - figure.curve.curve(figure.parameters[j])).norm() < 1e-13);
      CHECK(figure.residuals[j] == doctest::Approx((figure.feet[j] - object.points[j]).norm()));
      squares += figure.residuals[j] * figure.residuals[j];
      maximum = std::max(maximum, figure.residuals[j]);
    }
    CHECK(figure.rms == doctest::Approx(std::sqrt(squares / 20)));
    CHECK(figure.maximum == maximum);
    CHECK(figure.degree == 3);
    CHECK(figure.count == 8);
  }
}

TEST_CASE("fit figure: the errors against n hold the present one, and fall tenfold when the circle is closed") {
  const FitFigure open(experiment()), closed(experiment("least-squares-closed"));
  REQUIRE(open.errors.size() == 17);
  CHECK(open.errors[4].count == 8);
  CHECK(open.errors[4].rms == open.rms);
  CHECK(open.errors[4].maximum == open.maximum);
  REQUIRE(closed.errors.size() == 18);
  CHECK(closed.errors[5].count == 8);
  CHECK(open.errors[4].rms > 7 * closed.errors[5].rms);

  FittedCurveObject many = experiment();
  many.points.resize(200, Eigen::Vector3d::Zero());
  for (int j = 20; j < 200; ++j) many.points[static_cast<std::size_t>(j)] = {5.0 + 0.1 * j, std::sin(0.2 * j), 0};
  CHECK(FitFigure(many).errors.back().count == FitFigure::most_compared);
}

TEST_CASE("fit figure: the comparison is lent where only n changed, and made anew where anything else did") {
  FittedCurveObject object = experiment();
  const FitFigure before(object);
  object.count = 6;
  const FitFigure fewer(object, &before);
  CHECK(fewer.count == 6);
  CHECK(fewer.rms == doctest::Approx(0.1435259208));
  REQUIRE(fewer.errors.size() == before.errors.size());
  CHECK(fewer.errors[2].rms == fewer.rms);
  object.points[3] = {6, 6, 1};
  const FitFigure moved(object, &fewer);
  REQUIRE(moved.errors.size() == 17);
  CHECK(moved.errors[2].rms == moved.rms);
  CHECK(moved.errors[2].rms > 2 * fewer.errors[2].rms);
}

}  // namespace knotwork::scene::fit_figure_test
