#include "check/atlas_check.h"

#include <cmath>

#include "catch.h"

using namespace abflat;

namespace {

/// Squares of two triangles, each a chart.
struct Squares {
  std::vector<double> uv;
  std::vector<std::uint32_t> triangles, chartOf;
  std::uint32_t charts = 0, tiles = 1;
  double lowestV = 0;
  bool hasArea = true, mayTouch = false;

  Squares& add(double u, double v, double side) {
    const auto first = static_cast<std::uint32_t>(uv.size() / 2);
    for (const double x : {u, v, u + side, v, u + side, v + side, u, v + side}) uv.push_back(x);
    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) triangles.push_back(first + k);
    chartOf.push_back(charts);
    chartOf.push_back(charts++);
    return *this;
  }

  std::vector<ChartDefect> check() const {
    return checkAtlas({uv, triangles, chartOf, [this](std::size_t) { return hasArea; },
                       std::vector<std::uint8_t>(charts, 0),
                       std::vector<std::uint8_t>(charts, mayTouch), tiles, lowestV});
  }
};

}  // namespace

TEST_CASE("an atlas is valid until a chart is where it must not be", "[certificate]") {
  CHECK(Squares().check().empty());
  CHECK(Squares().add(0, 0, 1).check().empty());
  Squares two;
  two.add(0, 0, 0.25).add(0.5, 0.5, 0.25);
  CHECK(two.check().empty());

  Squares nested = two;
  nested.add(0.05, 0.05, 0.1);
  REQUIRE(nested.check().size() == 2);
  CHECK(nested.check()[0].kind == ChartDefect::Overlaps);
  CHECK(nested.check()[0].other == 2);
  CHECK(nested.check()[1].other == 0);

  Squares outside = two;
  outside.add(0.9, 0.5, 0.11);
  outside.add(1.2, 0.2, 0.5);
  for (const ChartDefect& d : outside.check()) CHECK(d.kind == ChartDefect::Outside);
  CHECK(outside.check().size() == 2);
  outside.tiles = 2;
  CHECK(outside.check().size() == 1);

  Squares below;
  below.add(0, -1, 1);
  CHECK(below.check().size() == 1);
  below.lowestV = -1;
  CHECK(below.check().empty());
}

TEST_CASE("flipped triangles, and those without area where the surface has some", "[certificate]") {
  Squares flipped;
  flipped.add(0, 0, 0.25).add(0.5, 0.5, 0.25);
  std::swap(flipped.triangles[7], flipped.triangles[8]);
  REQUIRE(flipped.check().size() == 1);
  CHECK(flipped.check()[0].chart == 1);
  CHECK(flipped.check()[0].triangles == 1);

  Squares flat;
  flat.add(0, 0, 0.25);
  flat.uv[4] = flat.uv[5] = 0;  // a triangle of two equal corners, another of none
  CHECK(flat.check().size() == 1);
  Squares broken;
  broken.add(0, 0, 0.25);
  broken.uv[3] = NAN;
  REQUIRE(broken.check().size() == 1);
  CHECK(broken.check()[0].kind == ChartDefect::Outside);
}

TEST_CASE("charts touch only where they may", "[certificate]") {
  Squares touching;
  touching.add(0, 0, 0.5).add(0.5, 0.25, 0.5);
  CHECK(touching.check().size() == 2);
  touching.mayTouch = true;
  CHECK(touching.check().empty());
  touching.uv[8] = std::nextafter(0.5, 0);
  CHECK(touching.check().size() == 2);
}

TEST_CASE("an edge with two triangles on one side is no boundary", "[certificate]") {
  Squares twice;
  twice.add(0, 0, 0.5);
  for (const std::uint32_t k : {0u, 1u, 2u}) twice.triangles.push_back(k);
  twice.chartOf.push_back(0);
  REQUIRE(twice.check().size() == 1);
  CHECK(twice.check()[0].other == 0);
}

TEST_CASE("a hole may lie at the outline, and another chart in the hole", "[certificate]") {
  Squares atlas;
  // The outline passes through the second corner, and so does the hole.
  atlas.uv = {0, 0, 0.2, 0, 0.4, 0, 0.4, 0.4, 0, 0.4, 0.3, 0.2, 0.1, 0.2};
  atlas.triangles = {0, 1, 6, 0, 6, 4, 4, 6, 5, 4, 5, 3, 5, 2, 3, 1, 2, 5};
  atlas.chartOf.assign(6, 0);
  atlas.charts = 1;
  CHECK(atlas.check().empty());
  atlas.add(0.19, 0.15, 0.02);
  CHECK(atlas.check().empty());
  Squares touching = atlas;
  touching.add(0.6, 0.6, 0.1).add(0.7, 0.65, 0.1);
  REQUIRE(touching.check().size() == 2);
  CHECK(touching.check()[0].other == 3);
  atlas.add(0.25, 0.05, 0.1);
  const std::vector<ChartDefect> defects = atlas.check();
  REQUIRE(defects.size() == 2);
  CHECK(defects[0].other == 2);
  CHECK(defects[1].other == 0);
}
