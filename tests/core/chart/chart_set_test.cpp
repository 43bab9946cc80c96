#include "chart/chart_set.h"

#include <set>

#include "catch.h"
#include "mesh/topology.h"
#include "support/cut_meshes.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Separates every triangle.
Seams allSeams(const Surface& surface) {
  Seams seams(surface.table.twin.size());
  for (const SurfaceCorner h : surface.table.corners()) seams[h] = surface.table.twin[h].exists();
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
  const DiskChart chart = set.chart(ChartId(0));
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
  REQUIRE(set.size() == surface.table.triangles().size());
  for (const SurfaceTriangle f : surface.table.triangles()) {
    const ChartId i = set.ofTriangle[f];
    CHECK(std::uint32_t{i} == std::uint32_t{f});
    const ChartTopology chart = set.topology(i);
    CHECK(chart.vertexCount() == 3);
    CHECK(chart.boundary.size() == 3);
    REQUIRE(chart.triangles.size() == 1);
    CHECK(chart.triangles.front() == f);
  }
}

TEST_CASE("a strip cut across falls into charts whose corners are those of the surface") {
  const Cuttable cuttable(bumpyGrid(8, 2, 0.2, 3));
  const Surface& surface = cuttable.surface;
  Seams seams(surface.table.twin.size(), 0);
  for (const SurfaceCorner h : surface.table.corners()) {
    // The edges of the grid's middle line.
    const std::uint32_t a = surface.table.vertex[h] % 9,
                        b = surface.table.vertex[nextCorner(h)] % 9;
    if (a == 4 && b == 4 && surface.table.twin[h].exists()) seams[h] = 1;
  }
  const ChartSet set = charts(cuttable, seams);
  REQUIRE(set.size() == 2);
  std::set<SurfaceCorner> seen;
  for (const ChartId i : set.ids()) {
    const ChartTopology chart = set.topology(i);
    for (const ChartCorner c : chart.surfaceCorners()) {
      const SurfaceCorner whole = chart.onSurface(c);
      CHECK(chart.inputVertex[chart.vertexOfCorner[c]] == surface.table.vertex[whole]);
      if (chart.twin[c].exists()) CHECK(chart.twin[chart.twin[c]] == c);
      seen.insert(whole);
    }
  }
  CHECK(seen.size() == surface.table.vertex.size());
}
