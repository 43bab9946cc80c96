#include "check/stacked_charts.h"

#include "catch.h"
#include "check/atlas_check.h"

using namespace abflat;

namespace {

/// L-shaped charts of four triangles, moved, mirrored and cut along either diagonal.
struct Charts {
  std::vector<double> uv;
  std::vector<std::uint32_t> triangles, chartOf;
  std::uint32_t count = 0;

  Charts& add(double u, double v, bool isClockwise = false, bool isOtherDiagonal = false) {
    const auto first = static_cast<std::uint32_t>(uv.size() / 2);
    const double at[6][2] = {{0, 0}, {.25, 0}, {.25, .125}, {.125, .125}, {.125, .25}, {0, .25}};
    for (const auto& p : at) uv.insert(uv.end(), {u + p[0], v + p[1]});
    const std::uint32_t one[] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5};
    const std::uint32_t other[] = {0, 1, 3, 1, 2, 3, 0, 3, 4, 0, 4, 5};
    for (std::size_t k = 0; k < 12; ++k) {
      const std::size_t i = isClockwise ? k / 3 * 3 + 2 - k % 3 : k;
      triangles.push_back(first + (isOtherDiagonal ? other : one)[i]);
    }
    chartOf.insert(chartOf.end(), 4, count++);
    return *this;
  }

  std::vector<StackedChart> stacked(bool mayMirror) const {
    return findStackedCharts(uv, triangles, chartOf, count, mayMirror);
  }
  std::vector<ChartDefect> check(bool mayMirror) const {
    WrittenAtlas atlas{uv,
                       triangles,
                       chartOf,
                       [](std::size_t) { return true; },
                       std::vector<std::uint8_t>(count, 0),
                       std::vector<std::uint8_t>(count, 0)};
    atlas.stacked = stacked(mayMirror);
    return checkAtlas(atlas);
  }
};

}  // namespace

TEST_CASE("charts with the same outline are stacked, others are not", "[certificate]") {
  Charts charts;
  charts.add(0, 0).add(.5, .5).add(0, 0).add(.5, .5, false, true);
  const std::vector<StackedChart> found = charts.stacked(false);
  CHECK(found[0].on == kOnNone);
  CHECK(found[1].on == kOnNone);
  CHECK(found[2].on == 0);
  CHECK(found[3].on == 1);
  CHECK(charts.check(false).empty());
  // One bit makes the difference.
  Charts off = charts;
  off.uv[2 * 6 * 2 + 3] += 1e-16;
  CHECK(off.stacked(false)[2].on == kOnNone);
  CHECK(off.check(false).size() == 2);
}

TEST_CASE("clockwise charts are stacked only if they may be mirrored", "[certificate]") {
  Charts charts;
  charts.add(0, 0, true).add(0, 0);
  CHECK(charts.stacked(false)[0].on == kOnNone);
  REQUIRE(charts.check(false).size() == 1);
  CHECK(charts.check(false)[0].kind == ChartDefect::Flipped);
  CHECK(charts.stacked(true)[0].on == 1);
  CHECK(charts.stacked(true)[0].isMirrored);
  CHECK(charts.check(true).empty());
  // By itself it lies on nothing.
  Charts alone;
  alone.add(0, 0, true);
  CHECK(alone.stacked(true)[0].on == kOnNone);
  CHECK(alone.check(true).size() == 1);
}

TEST_CASE("a triangle that is turned over in a stacked chart is found", "[certificate]") {
  Charts charts;
  charts.add(0, 0).add(0, 0);
  std::swap(charts.triangles[12], charts.triangles[13]);
  CHECK_FALSE(charts.check(true).empty());
}

TEST_CASE("what overlaps a stack overlaps all of it", "[certificate]") {
  Charts charts;
  charts.add(0, 0).add(0, 0).add(0, 0, true).add(.0625, .0625);
  const std::vector<ChartDefect> found = charts.check(true);
  REQUIRE(found.size() == 4);
  for (const ChartDefect& defect : found) CHECK(defect.kind == ChartDefect::Overlaps);
}

TEST_CASE("charts on one that is left out are compared with others", "[certificate]") {
  Charts charts;
  charts.add(0, 0).add(0, 0).add(.0625, .0625);
  WrittenAtlas atlas{charts.uv, charts.triangles, charts.chartOf, [](std::size_t) { return true; },
                     {1, 0, 0}, {0, 0, 0}};
  atlas.stacked = charts.stacked(true);
  REQUIRE(atlas.stacked[1].on == 0);
  const std::vector<ChartDefect> found = checkAtlas(atlas);
  REQUIRE(found.size() == 2);
  for (const ChartDefect& defect : found) CHECK(defect.kind == ChartDefect::Overlaps);
}
