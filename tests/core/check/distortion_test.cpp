#include "check/distortion.h"

#include <cmath>

#include "catch.h"
#include "check/validity.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// The chart's own x and y, mapped by the matrix (a b; c d).
std::vector<double> mapped(const DiskChart& chart, double a, double b, double c, double d) {
  std::vector<double> uv;
  for (const ChartVertex v : chart.vertices()) {
    const double x = chart.positions[3 * v], y = chart.positions[3 * v + 1];
    uv.insert(uv.end(), {a * x + b * y, c * x + d * y});
  }
  return uv;
}

}  // namespace

TEST_CASE("a similarity has no distortion") {
  const DiskChart chart = chartOf(bumpyGrid(6, 5, 0, 1));
  const Distortion d = measureDistortion(chart, mapped(chart, 3, -4, 4, 3));
  CHECK(d.angular < 1e-25);
  CHECK(d.length < 1e-25);
  for (double one : {d.quasiConformalMean, d.quasiConformalMax, d.stretchL2, d.stretchLinf,
                     d.symmetricDirichlet, d.areaMin, d.areaMax})
    CHECK(one == Approx(1));
}

TEST_CASE("an affine map has the distortion of its singular values") {
  const DiskChart chart = chartOf(bumpyGrid(6, 5, 0, 1));
  // Rotation times diag(4, 1): at equal area the singular values are 2 and 1/2.
  const Distortion d = measureDistortion(chart, mapped(chart, 4 * 0.6, -0.8, 4 * 0.8, 0.6));
  CHECK(d.quasiConformalMean == Approx(4));
  CHECK(d.quasiConformalMax == Approx(4));
  CHECK(d.stretchLinf == Approx(2));
  CHECK(d.stretchL2 == Approx(std::sqrt((4 + 0.25) / 2)));
  CHECK(d.symmetricDirichlet == Approx((4 + 0.25 + 4 + 0.25) / 4));
  CHECK(d.areaMin == Approx(1));
  CHECK(d.areaMax == Approx(1));
  CHECK(d.angular > 0.01);
  CHECK(d.length > 0.01);
}

TEST_CASE("the sheared share is that of the area whose singular values are more than 1.25 apart") {
  const DiskChart chart = chartOf(bumpyGrid(6, 5, 0, 1));
  CHECK(measureDistortion(chart, mapped(chart, 1.24, 0, 0, 1)).sheared == 0);
  CHECK(measureDistortion(chart, mapped(chart, 1.26, 0, 0, 1)).sheared == Approx(1));
  CHECK(measureDistortion(chart, mapped(chart, 0, 3, -4, 0)).sheared == Approx(1));
  // Two squares of areas 3 and 1, the smaller one pulled out.
  const DiskChart two =
      chartOf(makeTriangleMesh({0, 0, 0, 3, 0, 0, 4, 0, 0, 4, 1, 0, 3, 1, 0, 0, 1, 0},
                               {0, 1, 4, 0, 4, 5, 1, 2, 3, 1, 3, 4}));
  std::vector<double> uv;
  for (std::size_t v = 0; v < 6; ++v) {
    const double x = two.positions[3 * v] * two.unit;
    uv.insert(uv.end(), {x > 3.5 ? x + 1 : x, two.positions[3 * v + 1] * two.unit});
  }
  CHECK(measureDistortion(two, uv).sheared == Approx(0.25));
}

TEST_CASE("area distortion is the mean size of the logarithm of the area ratios") {
  // A square of two equal triangles whose areas become 3 to 1: 3/2 and 1/2 at equal total area.
  const DiskChart chart =
      chartOf(makeTriangleMesh({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {0, 1, 2, 0, 2, 3}));
  const Distortion d = measureDistortion(chart, {0, 0, 3, 0, 1, 1, 0, 1});
  CHECK(d.areaLog == Approx((std::log(1.5) + std::log(2)) / 2));
  CHECK(d.areaMin == Approx(0.5));
  CHECK(d.areaMax == Approx(1.5));
}

TEST_CASE("flipped triangles and boundary angles are seen") {
  const DiskChart chart = chartOf(bumpyGrid(6, 5, 0, 1));
  std::vector<double> uv = mapped(chart, 1, 0, 0, 1);
  const Validity good = checkValidity(chart, uv);
  CHECK(good.valid());
  CHECK(good.degenerateTriangles == 0);
  CHECK(good.maxBoundaryAngle > 3);
  CHECK(checkValidity(chart, mapped(chart, 1, 0, 0, -1)).flippedTriangles == chart.triangleCount());
  // Pushes one interior vertex out of its ring of triangles.
  for (const ChartVertex v : chart.vertices())
    if (std::abs(chart.positions[3 * v] - 3 / chart.unit) +
            std::abs(chart.positions[3 * v + 1] - 2 / chart.unit) <
        0.8 / chart.unit) {
      uv[2 * v] += 2 / chart.unit;
      break;
    }
  const Validity pushed = checkValidity(chart, uv);
  CHECK(pushed.flippedTriangles > 0);
  CHECK_FALSE(pushed.valid());
  uv[0] = std::nan("");
  CHECK(checkValidity(chart, uv).flippedTriangles > pushed.flippedTriangles - 1);
}

TEST_CASE("an overlap without flipped triangles is a boundary crossing") {
  // A fan that turns by more than 2 pi.
  constexpr unsigned kCount = 14;
  std::vector<double> p{0, 0, 0}, uv{0, 0};
  std::vector<std::uint32_t> t;
  for (unsigned i = 0; i <= kCount; ++i) {
    const double u = 0.5 * i, r = 1 + 0.02 * i;
    p.insert(p.end(), {r * std::cos(u), r * std::sin(u), 0.1 * i});
    uv.insert(uv.end(), {r * std::cos(u), r * std::sin(u)});
    if (i > 0) t.insert(t.end(), {0, i, i + 1});
  }
  const Validity v = checkValidity(chartOf(makeTriangleMesh(p, t)), uv);
  CHECK(v.flippedTriangles == 0);
  CHECK(v.crossings.count > 0);
  CHECK(v.maxBoundaryAngle == Approx(7));
}
