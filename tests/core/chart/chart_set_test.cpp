#include "chart/chart_set.h"

#include <set>

#include "catch.h"
#include "mesh/topology.h"
#include "support/cut_meshes.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Every triangle by itself.
Seams allSeams(const Surface& surface) {
  Seams seams(surface.table.twin.size());
  for (std::size_t h = 0; h < seams.size(); ++h) seams[h] = surface.table.twin[h] != kNone;
  return seams;
}

ChartSet charts(const Cuttable& c, const Seams& seams) {
  return makeCharts(c.mesh, filledTable(c.seamMesh, c.surface.fans.inputVertex, seams));
}

}  // namespace

TEST_CASE("without seams a disk is its own chart") {
  const Cuttable c(bumpyGrid(6, 5, 0.3, 2));
  const ChartSet set = charts(c, Seams(c.surface.table.twin.size(), 0));
  REQUIRE(set.size() == 1);
  const DiskChart wanted = makeDiskChart(c.mesh, c.surface);
  const DiskChart chart = set.chart(0);
  CHECK(chart.vertexOfCorner == wanted.vertexOfCorner);
  CHECK(chart.twin == wanted.twin);
  CHECK(chart.boundary == wanted.boundary);
  CHECK(chart.inputVertex == wanted.inputVertex);
  CHECK(chart.positions == wanted.positions);
}

TEST_CASE("cut along all edges a surface is its triangles") {
  const Cuttable c(torus(5, 4));
  const Surface& surface = c.surface;
  const ChartSet set = charts(c, allSeams(surface));
  REQUIRE(set.size() == surface.table.triangleCount());
  for (std::uint32_t f = 0; f < set.size(); ++f) {
    CHECK(set.topology(f).vertexCount() == 3);
    CHECK(set.topology(f).boundary.size() == 3);
    REQUIRE(set.triangles(f).size() == 1);
    CHECK(set.triangles(f).front() == f);
    CHECK(set.ofTriangle[f] == f);
  }
}

TEST_CASE("a strip cut across falls into charts whose corners are those of the surface") {
  const Cuttable cuttable(bumpyGrid(8, 2, 0.2, 3));
  const Surface& surface = cuttable.surface;
  Seams seams(surface.table.twin.size(), 0);
  for (std::uint32_t h = 0; h < seams.size(); ++h) {
    // The edges of the grid's middle line.
    const std::uint32_t a = surface.table.vertex[h] % 9,
                        b = surface.table.vertex[nextCorner(h)] % 9;
    if (a == 4 && b == 4 && surface.table.twin[h] != kNone) seams[h] = 1;
  }
  const ChartSet set = charts(cuttable, seams);
  REQUIRE(set.size() == 2);
  std::set<std::uint32_t> seen;
  for (std::size_t i = 0; i < 2; ++i) {
    const DiskChart chart = set.chart(i);
    for (std::uint32_t c = 0; c < chart.vertexOfCorner.size(); ++c) {
      const std::uint32_t whole = 3 * set.triangles(i)[c / 3] + c % 3;
      CHECK(chart.inputVertex[chart.vertexOfCorner[c]] == surface.table.vertex[whole]);
      if (chart.twin[c] != kNone) CHECK(chart.twin[chart.twin[c]] == c);
      seen.insert(whole);
    }
  }
  CHECK(seen.size() == surface.table.vertex.size());
}
