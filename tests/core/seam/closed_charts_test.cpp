#include "seam/closed_charts.h"

#include "catch.h"
#include "seam/find_seams.h"
#include "support/cut_meshes.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// The same in the slow way: the whole surface is cut, but for slits that are not kept.
SeamPart extractedSlowly(const SeamMesh& mesh, const Seams& seams, const Seams& kept,
                         const std::vector<SurfaceTriangle>& ofCharts) {
  const CutSurface s = cutAlong(mesh, seams);
  Seams between = seams;
  for (const SurfaceCorner h : between.ids()) {
    const SurfaceCorner o = mesh.twin[h];
    if (o.exists() && s.chartOf(h) == s.chartOf(o) && !(h < kept.size() && kept[h])) between[h] = 0;
  }
  const CutSurface apart = cutAlong(mesh, between);
  IdVector<CutChartId, std::uint8_t> isWanted(apart.charts.size(), 0);
  for (const SurfaceTriangle f : ofCharts) isWanted[apart.chartOfTriangle[f]] = 1;
  return extractCharts(mesh, apart, isWanted);
}

void checkSame(const SeamPart& a, const SeamPart& b) {
  CHECK(a.wholeHalfEdge.raw() == b.wholeHalfEdge.raw());
  CHECK(a.wholeVertex.raw() == b.wholeVertex.raw());
  CHECK(a.mesh.twin.raw() == b.mesh.twin.raw());
  CHECK(a.mesh.vertexOfCorner.raw() == b.mesh.vertexOfCorner.raw());
  CHECK(a.mesh.positions == b.mesh.positions);
  CHECK(a.mesh.angleSum.raw() == b.mesh.angleSum.raw());
  CHECK(a.mesh.vertexArea.raw() == b.mesh.vertexArea.raw());
}

void checkCharts(const PolygonMesh& mesh) {
  const Cuttable c(mesh);
  const SeamMesh& m = c.seamMesh;
  SeamReport report;
  const Seams seams = findSeams(m, {}, {}, &report);
  const CutSurface s = cutAlong(m, seams);
  std::vector<SurfaceTriangle> all, some;
  for (const CutChartId i : s.charts.ids()) {
    all.push_back(s.charts[i].firstTriangle);
    if (i % 2 == 0) some.push_back(all.back());
  }
  Seams kept(seams.size() / 2, 0);
  for (const SurfaceCorner h : kept.ids()) kept[h] = seams[h] && m.twin[h] < kept.size();
  for (const auto& wanted : {all, some, std::vector<SurfaceTriangle>()}) {
    checkSame(extractClosed(m, seams, {}, wanted), extractedSlowly(m, seams, {}, wanted));
    checkSame(extractClosed(m, seams, kept, wanted), extractedSlowly(m, seams, kept, wanted));
  }
}

}  // namespace

TEST_CASE("charts are taken out of a surface as if all of it were cut", "[seams]") {
  checkCharts(torus(24, 16));
  checkCharts(dentedBall({0, 1, 0}));
  checkCharts(uvSphere(16, 12));
  checkCharts(bumpyGrid(30, 30, 1.5, 3));
}
