#include "mesh/surface.h"

#include <algorithm>
#include <set>

#include "abflat/inspect.h"
#include "catch.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

StatusCode diskCode(const PolygonMesh& mesh) { return inspect(mesh).disk.code; }

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a grid is a disk with the expected counts") {
  const MeshSummary m = inspect(bumpyGrid(7, 5, 0.3, 1));
  CHECK(m.disk.ok());
  CHECK(m.vertices == 48);
  CHECK(m.triangles == 70);
  CHECK(m.components == 1);
  CHECK(m.boundaryLoops == 1);
  CHECK(m.boundaryEdges == 24);
  CHECK(m.eulerCharacteristic == 1);
  CHECK(m.genus == 0);
  CHECK(m.unreferencedVertices == 0);
  CHECK(m.degenerateFaces == 0);
}

TEST_CASE("texcoords and different materials are counted") {
  PolygonMesh mesh = tetrahedron();
  CHECK(inspect(mesh).texcoords == 0);
  CHECK(inspect(mesh).materials == 0);
  mesh.texcoords = {0, 0, 1, 0, 0, 1};
  mesh.faceTexcoords.assign(mesh.faceVertices.size(), 2);
  mesh.faceMaterials = {7, 0, 7, 0};
  CHECK(inspect(mesh).texcoords == 3);
  CHECK(inspect(mesh).materials == 2);
}

TEST_CASE("surfaces that are no disk say what they are") {
  CHECK(diskCode(PolygonMesh{}) == StatusCode::EmptyMesh);

  const MeshSummary closed = inspect(tetrahedron());
  CHECK(closed.disk.code == StatusCode::ClosedSurface);
  CHECK(closed.eulerCharacteristic == 2);

  const MeshSummary handle = inspect(torus(8, 6));
  CHECK(handle.disk.code == StatusCode::ClosedSurface);
  CHECK(handle.genus == 1);
  CHECK(handle.eulerCharacteristic == 0);
  CHECK(contains(handle.disk.message, "genus 1"));

  PolygonMesh open = torus(8, 6);
  open.faceVertices.resize(open.faceVertices.size() - 3);
  open.faceOffsets.pop_back();
  CHECK(diskCode(open) == StatusCode::HasHandles);
  CHECK(inspect(open).genus == 1);

  const MeshSummary tube = inspect(cylinder(8, 3));
  CHECK(tube.disk.code == StatusCode::MultipleBoundaryLoops);
  CHECK(contains(tube.disk.message, "2 boundary loops"));

  PolygonMesh two = tetrahedron();
  for (double x : tetrahedron().positions) two.positions.push_back(x + 5);
  for (std::uint32_t v : tetrahedron().faceVertices) {
    two.faceVertices.push_back(v + 4);
    if (two.faceVertices.size() % 3 == 0)
      two.faceOffsets.push_back(static_cast<std::uint32_t>(two.faceVertices.size()));
  }
  CHECK(diskCode(two) == StatusCode::MultipleComponents);
  CHECK(contains(inspect(two).disk.message, "2 components"));
}

TEST_CASE("edges that are no part of an oriented manifold are named") {
  const std::vector<double> p{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1};
  const MeshSummary three = inspect(makeTriangleMesh(p, {0, 1, 2, 1, 0, 3, 0, 1, 4}));
  CHECK(three.disk.code == StatusCode::NonManifoldEdge);
  CHECK(three.nonManifoldEdges == 1);
  CHECK(three.boundaryEdges == 6);
  CHECK(three.eulerCharacteristic == 5 - 7 + 3);
  CHECK(contains(three.disk.message, "edge 0-1 has 3 faces"));

  const MeshSummary turned = inspect(makeTriangleMesh(p, {0, 1, 2, 0, 1, 3}));
  CHECK(turned.disk.code == StatusCode::InconsistentOrientation);
  CHECK(turned.orientationConflicts == 1);
  CHECK(turned.boundaryEdges == 4);
  CHECK(contains(turned.disk.message, "face 1 has opposite orientation to face 0"));

  const MeshSummary repeated = inspect(makeTriangleMesh(p, {0, 1, 2, 2, 1, 1}));
  CHECK(repeated.disk.code == StatusCode::DegenerateFace);
  CHECK(contains(repeated.disk.message, "face 1 uses vertex 1 twice"));
}

TEST_CASE("a surface that touches itself at a vertex is cut there") {
  const std::vector<double> q{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, -1, 0, 0, -1, -1, 0, 0, -1, 0};
  const PolygonMesh bowTie = makeTriangleMesh(q, {0, 1, 2, 0, 2, 3, 0, 4, 5, 0, 5, 6});
  const MeshSummary m = inspect(bowTie);
  CHECK(m.components == 2);
  CHECK(buildSurface(bowTie).fans.inputVertex.size() == 8);
  CHECK(m.eulerCharacteristic == 7 - 10 + 4);
}

TEST_CASE("unreferenced vertices are counted and do not matter") {
  PolygonMesh mesh = bumpyGrid(3, 3, 0.1, 2);
  mesh.positions.insert(mesh.positions.begin(), {9, 9, 9});
  for (std::uint32_t& v : mesh.faceVertices) ++v;
  const MeshSummary m = inspect(mesh);
  CHECK(m.unreferencedVertices == 1);
  CHECK(m.eulerCharacteristic == 1);
  CHECK(m.disk.ok());
}

TEST_CASE("twins are mutual and run in opposite directions; loops cover the boundary once") {
  const PolygonMesh mesh = renumbered(bumpyGrid(9, 4, 0.3, 3), 4).mesh;
  const Surface s = buildSurface(mesh);
  for (const SurfaceCorner h : s.table.corners()) {
    const SurfaceCorner t = s.table.twin[h];
    if (!t.exists()) continue;
    CHECK(s.table.twin[t] == h);
    CHECK(s.table.vertex[t] == s.table.vertex[nextCorner(h)]);
    CHECK(s.table.vertex[nextCorner(t)] == s.table.vertex[h]);
  }
  REQUIRE(s.boundaryLoops.size() == 1);
  const auto& loop = s.boundaryLoops[0];
  CHECK(std::set<std::uint32_t>(loop.begin(), loop.end()).size() == 26);
  for (std::size_t i = 0; i < loop.size(); ++i)
    CHECK(s.table.vertex[nextCorner(loop[i])] == s.table.vertex[loop[(i + 1) % loop.size()]]);
}

TEST_CASE("concave faces keep their area and every edge when triangulated") {
  for (unsigned n : {3u, 5u, 20u, 60u}) {
    const PolygonMesh mesh = star(n);
    const Triangulation t = triangulate(mesh);
    REQUIRE(t.face.size() == 2 * n - 2);
    double area = 0, polygon = 0;
    const auto twice = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      const auto x = [&](std::uint32_t v) { return mesh.positions[3 * v]; };
      const auto y = [&](std::uint32_t v) { return -mesh.positions[3 * v + 2]; };
      return (x(b) - x(a)) * (y(c) - y(a)) - (y(b) - y(a)) * (x(c) - x(a));
    };
    for (const SurfaceTriangle f : t.face.ids()) {
      const std::array<std::uint32_t, 3> v = verticesOf(t.vertex, f);
      const double a = twice(v[0], v[1], v[2]);
      CHECK(a > 0);
      area += a;
    }
    for (std::uint32_t i = 1; i + 1 < 2 * n; ++i) polygon += twice(0, i, i + 1);
    CHECK(area == Approx(polygon));
    const MeshSummary m = inspect(mesh);
    CHECK(m.disk.ok());
    CHECK(m.boundaryEdges == 2 * n);
  }
}

TEST_CASE("two quads that share two edges are cut so that the flat mesh exists") {
  PolygonMesh mesh;
  // Vertex 1 has only two faces: (0 1 2 3) and (2 1 0 4).
  mesh.positions = {0, 0, 0, 1, 0, 1, 2, 0, 0, 1, 2, 0, 1, -2, 0};
  mesh.faceVertices = {0, 1, 2, 3, 2, 1, 0, 4};
  mesh.faceOffsets = {0, 4, 8};
  const Surface s = buildSurface(mesh);
  CHECK(s.summary.disk.ok());
  CHECK(s.summary.nonManifoldEdges == 0);
  CHECK(std::count(s.table.vertex.begin(), s.table.vertex.end(), 1u) >= 3);
}
