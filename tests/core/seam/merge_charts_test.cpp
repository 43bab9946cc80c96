#include "seam/merge_charts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "catch.h"
#include "seam/log_scale.h"
#include "seam/merge_trial.h"
#include "seam/outlines_together.h"
#include "seam/prediction.h"
#include "support/cut_meshes.h"
#include "support/isosurface.h"
#include "support/meshes.h"
#include "support/squares.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// The inner edges of a grid along some of its columns.
Seams alongColumns(const SeamMesh& m, int count, const std::vector<int>& columns) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const SurfaceVertex v : m.vertices()) {
    low = std::min(low, m.positions[3 * v]);
    high = std::max(high, m.positions[3 * v]);
  }
  const auto columnOf = [&](SurfaceVertex v) {
    return static_cast<int>(std::lround(count * (m.positions[3 * v] - low) / (high - low)));
  };
  Seams seams(m.twin.size(), 0);
  for (const SurfaceCorner h : seams.ids()) {
    if (!m.twin[h].exists()) continue;
    const int a = columnOf(m.vertexOfCorner[h]), b = columnOf(m.head(h));
    for (const int x : columns) seams[h] |= a == x && b == x;
  }
  return seams;
}

std::uint32_t merged(const SeamMesh& mesh, const Seams& kept, Seams& seams) {
  LogScale scale(mesh, nullptr);
  LogScales u = scale.solve(cutAlong(mesh, seams), {});
  SeamOptions options;
  options.prices = SeamPrices::none();
  return mergeCharts({mesh, kept, options, scale, u, seams});
}

Outline box(double x, double y, double w, double h) {
  return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
}

}  // namespace

TEST_CASE("strips of a flat sheet become one chart again, but for seams that are kept", "[merge]") {
  const Cuttable c(squares(12, 6, [](auto, auto) { return true; }));
  const SeamMesh& m = c.seamMesh;
  Seams seams = alongColumns(m, 12, {3, 6, 9});
  REQUIRE(cutAlong(m, seams).charts.size() == 4);
  SECTION("none") {
    CHECK(merged(m, Seams(seams.size(), 0), seams) == 3);
    CHECK(cutAlong(m, seams).charts.size() == 1);
    CHECK(seams == Seams(seams.size(), 0));
  }
  SECTION("one") {
    const Seams kept = alongColumns(m, 12, {6});
    CHECK(merged(m, kept, seams) == 2);
    CHECK(seams == kept);
  }
}

TEST_CASE("strips become one chart beside a surface that is much larger", "[merge]") {
  const Cuttable c(squares(40, 6, [](auto i, auto) { return i != 12; }));
  const SeamMesh& m = c.seamMesh;
  Seams seams = alongColumns(m, 40, {3, 6, 9});
  REQUIRE(cutAlong(m, seams).charts.size() == 5);
  CHECK(merged(m, Seams(seams.size(), 0), seams) == 3);
  CHECK(cutAlong(m, seams).charts.size() == 2);
}

TEST_CASE("charts stay apart where together they would take more room", "[merge]") {
  const Cuttable c(squares(12, 12, [](auto i, auto j) { return i < 2 || j < 2; }));
  const Seams seams = alongColumns(c.seamMesh, 12, {2});
  Seams after = seams;
  CHECK(merged(c.seamMesh, Seams(seams.size(), 0), after) == 0);
  CHECK(after == seams);
}

TEST_CASE("charts hang together by a part of their seam where all of it cannot be joined",
          "[merge]") {
  const Cuttable c(isosurface(24, rings(1)));
  SeamOptions tight;
  tight.maxStretch = 1.02;
  SeamReport report;
  const Seams seams = findSeams(c.seamMesh, {}, tight, &report);
  const CutSurface s = cutAlong(c.seamMesh, report.found);
  // Seams that end within a chart, between two charts that were separate.
  std::size_t ends = 0;
  IdVector<SurfaceVertex, int> degree(c.seamMesh.vertexCount(), 0);
  for (const SurfaceCorner h : report.found.ids())
    if (report.found[h]) ++degree[c.seamMesh.tail(h)];
  for (const int d : degree) ends += d == 1;
  CHECK(ends >= 2);
  CHECK(s.charts.size() <= 3);
  for (const CutSurface::Chart& chart : s.charts) CHECK(chart.isDisk());
  CHECK(report.stretch <= tight.maxStretch);
}

TEST_CASE("joined charts keep the bounds, and no seam is added", "[merge][quality]") {
  for (const PolygonMesh& mesh : {isosurface(24, rings(2)), isosurface(28, noise(2, 4))}) {
    const Cuttable c(mesh, SeamCosts::Length);
    SeamOptions tight;
    tight.maxStretch = 1.01;
    tight.prices = SeamPrices::none();
    const Seams before = findSeams(c.seamMesh, {}, tight, nullptr);
    Seams seams = before;
    const std::uint32_t done = merged(c.seamMesh, Seams(before.size(), 0), seams);
    const CutSurface s = cutAlong(c.seamMesh, seams);
    CHECK(done > 0);
    CHECK(s.charts.size() == cutAlong(c.seamMesh, before).charts.size() - done);
    for (const CutSurface::Chart& chart : s.charts) CHECK(chart.isDisk());
    for (const SurfaceCorner h : seams.ids()) REQUIRE(seams[h] <= before[h]);
    const LogScales u = LogScale(c.seamMesh, nullptr).solve(s, {});
    for (const double stretch : predictStretch(c.seamMesh, s, u).stretch)
      CHECK(stretch <= SeamOptions().maxStretch);
  }
}

TEST_CASE("the room of two outlines does not depend on how they lie", "[merge]") {
  const Outline a = box(0, 0, 2, 1);
  const auto pairs = [](unsigned a0, unsigned b0, unsigned a1, unsigned b1) {
    return OutlinePairs{{BoundaryIndex(a0), BoundaryIndex(b0)},
                        {BoundaryIndex(a1), BoundaryIndex(b1)}};
  };
  const OutlinePairs side = pairs(1, 0, 2, 3);
  CHECK(hullTogether(a, box(2, 0, 3, 1), side) == Approx(1));
  Outline turned;
  for (const Point2& p : box(2, 0, 3, 1))
    turned.push_back({5 + 0.6 * p[0] - 0.8 * p[1], -7 + 0.8 * p[0] + 0.6 * p[1]});
  CHECK(hullTogether(a, turned, side) == Approx(1));
  // A unit square on the left half of the upper side.
  CHECK(hullTogether(a, {{0, 1}, {1, 1}, {1, 2}, {0, 2}}, pairs(3, 0, 3, 0)) ==
        std::numeric_limits<double>::infinity());
  const Outline wide = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
  CHECK(hullTogether(wide, box(0, 1, 1, 1), pairs(4, 0, 3, 1)) == Approx(3.5 / 3));
}

TEST_CASE("a trial of a part sees the charts joined, and leaves the whole as it was", "[merge]") {
  // Cut all around into many charts, of which each trial joins two.
  const Cuttable c(torus(40, 24));
  const SeamMesh& m = c.seamMesh;
  SeamOptions options;
  options.maxStretch = 1.0005;
  Seams seams = findSeams(m, Seams(m.twin.size(), 0), options, nullptr);
  const Seams kept(seams.size(), 0), before = seams;
  LogScale scale(m, nullptr);
  LogScales u = scale.solve(cutAlong(m, seams), {});
  const SeamWork work{m, kept, options, scale, u, seams};
  const CutSurface whole = cutAlong(m, seams);
  std::size_t parts = 0;
  for (const SharedRun& run : sharedRuns(m, kept, whole)) {
    seams = before;
    for (const SurfaceCorner h : run.edges) seams[h] = seams[m.twin[h]] = 0;
    std::optional<CutSurface> apart = whole;
    const MergeTrial trial(work, {{run}}, apart, {});
    if (!apart) continue;  // a trial on the whole
    ++parts;
    REQUIRE(apart->twin == whole.twin);
    REQUIRE(apart->vertexOfCorner == whole.vertexOfCorner);
    const CutSurface joined = cutAlong(m, seams);
    const CutSurface::Chart& expected = joined.charts[joined.chartOf(run.edges.front())];
    const CutSurface::Chart& found = trial.joined().charts[trial.joinedAt(run)];
    REQUIRE(trial.joined().charts.size() == 1);
    REQUIRE(found.triangles == expected.triangles);
    REQUIRE(found.vertices == expected.vertices);
    REQUIRE(found.edges == expected.edges);
    REQUIRE(found.loops == expected.loops);
    REQUIRE(trial.apart().charts.size() == 2);
  }
  CHECK(parts > 20);
}
