#include "seam/components_with_seams.h"

#include "catch.h"
#include "support/copies.h"
#include "support/cut_meshes.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// A closed torus, and so many flat triangles beside it.
PolygonMesh torusAmongTriangles(unsigned triangles) {
  PolygonMesh out = torus(12, 8);
  for (unsigned i = 0; i < triangles; ++i) {
    const double x = 10 + 2.0 * i;
    append(out, makeTriangleMesh({x, 0, 0, x + 1, 0, 0, x, 1, 0}, {0, 1, 2}));
  }
  return out;
}

Seams seamsOf(const SeamMesh& mesh) {
  SeamReport report;
  return findSeams(mesh, {}, {}, &report);
}

}  // namespace

TEST_CASE("components without seams are left out, unless that is hardly anything", "[seams]") {
  const Cuttable many(torusAmongTriangles(60));
  const SeamMesh& m = many.seamMesh;
  const Seams seams = seamsOf(m);
  const auto part = componentsWithSeams(m, seams, {});
  REQUIRE(part);
  CHECK(part->mesh.triangleCount() == 12 * 8 * 2);
  CHECK(cutAlong(part->mesh, part->ofCorners(seams)).charts.size() + 60 ==
        cutAlong(m, seams).charts.size());
  for (const SurfaceCorner h : part->wholeHalfEdge.ids()) {
    const SurfaceCorner o = part->mesh.twin[h];
    REQUIRE(o.exists());
    CHECK(m.twin[part->wholeHalfEdge[h]] == part->wholeHalfEdge[o]);
  }
  const Cuttable few(torusAmongTriangles(8));
  CHECK(componentsWithSeams(few.seamMesh, seamsOf(few.seamMesh), {}) == nullptr);
}

TEST_CASE("where nothing has a seam, nothing is left", "[seams]") {
  const Cuttable c(copies(bumpyGrid(3, 3, 0.01, 1), 9, 2));
  const auto part = componentsWithSeams(c.seamMesh, Seams(c.seamMesh.twin.size(), 0), {});
  REQUIRE(part);
  CHECK(part->mesh.triangleCount() == 0);
  CHECK(seamsOf(c.seamMesh) == Seams(c.seamMesh.twin.size(), 0));
}

TEST_CASE("a surface is cut the same whatever lies beside it", "[seams]") {
  const Cuttable alone(torusAmongTriangles(0)), among(torusAmongTriangles(60));
  SeamReport own, both;
  findSeams(alone.seamMesh, {}, {}, &own);
  findSeams(among.seamMesh, {}, {}, &both);
  CHECK(both.charts == own.charts + 60);
}
