#include "seam/slits.h"

#include <cmath>

#include "catch.h"
#include "support/cut_meshes.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

TEST_CASE("a chart that is stretched most at its boundary gets a slit as well", "[seams]") {
  // Three squares wide, so every interior vertex has neighbours on the boundary.
  const Cuttable c(bumpyGrid(12, 3, 0.1, 1));
  const CutSurface s = cutAlong(c.seamMesh, Seams(c.seamMesh.twin.size()));
  REQUIRE(s.charts.size() == 1);
  LogScales u(c.seamMesh.vertexCount(), 0);
  OpenVertex farthest(0);
  for (const OpenVertex v : s.vertices()) {
    if (s.isBoundary[v]) continue;
    u[s.meshVertex[v]] = 1 + 1e-3 * std::sin(std::uint32_t{v});
    if (u[s.meshVertex[v]] > u[s.meshVertex[farthest]]) farthest = v;
  }
  const Prediction prediction = predictStretch(c.seamMesh, s, u);
  REQUIRE(prediction.stretch.front() > 1.2);
  const CutChartId chart(0);
  for (const OpenVertex v : s.vertices())
    if (!s.isBoundary[v])
      REQUIRE(prediction.at(chart, u[s.meshVertex[v]]) < prediction.at(chart, 0));
  const PathForest forest = findPaths(c.seamMesh, s, {});
  const CutPaths paths{c.seamMesh, s, forest};
  CHECK(slitEnds(paths, prediction, u, 1.04) == std::vector{farthest});
  CHECK(slitEnds(paths, prediction, u, 2 * prediction.stretch.front()).empty());
}
