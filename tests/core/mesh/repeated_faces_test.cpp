#include "mesh/repeated_faces.h"

#include <algorithm>

#include "catch.h"
#include "mesh/surface.h"
#include "mesh/welded_mesh.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// The same triangles, and those asked for once more with the other side up, before or after them.
template <class IsAsked>
PolygonMesh withBackSides(const PolygonMesh& mesh, bool isBefore, const IsAsked& isAsked) {
  std::vector<std::uint32_t> backs;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    if (isAsked(f))
      for (const std::uint32_t k : {2u, 1u, 0u}) backs.push_back(mesh.faceVertices[3 * f + k]);
  std::vector<std::uint32_t> all = isBefore ? backs : mesh.faceVertices;
  const std::vector<std::uint32_t>& rest = isBefore ? mesh.faceVertices : backs;
  all.insert(all.end(), rest.begin(), rest.end());
  return makeTriangleMesh(mesh.positions, all);
}

Surface surfaceOf(const PolygonMesh& mesh) {
  const WeldedMesh welded = weld(mesh, true);
  return buildSurface(welded.mesh);
}

}  // namespace

TEST_CASE("a surface that is there twice is two surfaces, however its faces are numbered") {
  const PolygonMesh mesh = withBackSides(torus(12, 8), false, [](std::uint32_t) { return true; });
  for (unsigned seed = 1; seed < 6; ++seed) {
    const MeshSummary m = surfaceOf(renumbered(mesh, seed).mesh).summary;
    CHECK(m.components == 2);
    CHECK(m.boundaryEdges == 0);
    CHECK(m.orientationConflicts == 0);
  }
}

TEST_CASE("back sides of some faces make no holes in the surface") {
  const PolygonMesh closed = torus(20, 10);
  for (const std::uint32_t step : {3u, 7u, 50u})
    for (const bool isBefore : {false, true}) {
      const auto isAsked = [&](std::uint32_t f) { return f % step == 0; };
      const PolygonMesh mesh = withBackSides(closed, isBefore, isAsked);
      const Surface s = surfaceOf(mesh);
      const Components parts = findComponents(s.table);
      std::vector<std::size_t> sizes(parts.firstTriangle.size(), 0);
      for (const SurfaceTriangle f : s.table.triangles()) ++sizes[parts.ofTriangle[f]];
      CHECK(*std::max_element(sizes.begin(), sizes.end()) == closed.faceCount());
      CHECK(s.summary.orientationConflicts == 0);
    }
}

TEST_CASE("repeated faces are told by the first of their kind") {
  const PolygonMesh mesh =
      makeTriangleMesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, {0, 1, 2, 2, 1, 3, 0, 2, 1, 1, 2, 0});
  const RepeatedFaces found = findRepeated(mesh, {});
  CHECK(found.original == std::vector<std::uint32_t>{kNone, kNone, 0, 0});
  CHECK(found.layer == std::vector<std::uint32_t>{0, 0, 2, 1});
}
