#include "mesh/welded_mesh.h"

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "mesh/surface.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

PolygonMesh meshOf(std::vector<double> positions,
                   const std::vector<std::vector<std::uint32_t>>& faces) {
  PolygonMesh mesh;
  mesh.positions = std::move(positions);
  mesh.faceOffsets.push_back(0);
  for (const auto& face : faces) {
    mesh.faceVertices.insert(mesh.faceVertices.end(), face.begin(), face.end());
    mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
  }
  return mesh;
}

const std::vector<double> kSquare{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

}  // namespace

TEST_CASE("loose triangles are the surface they show") {
  for (const PolygonMesh& mesh : {tetrahedron(), torus(9, 7), star(5)}) {
    const WeldedMesh welded = weld(exploded(mesh));
    const MeshSummary found = buildSurface(welded.mesh).summary, wanted = inspect(mesh);
    CHECK(found.components == wanted.components);
    CHECK(found.boundaryLoops == wanted.boundaryLoops);
    CHECK(found.genus == wanted.genus);
    CHECK(welded.mergedVertices == mesh.faceVertices.size() - mesh.vertexCount());
    for (const InputCorner c : welded.cornerFor.ids())
      CHECK(std::uint32_t{welded.cornerFor[c]} == std::uint32_t{c});
  }
}

TEST_CASE("without positions vertices are what the mesh says") {
  const WeldedMesh welded = weld(exploded(tetrahedron()), false);
  CHECK(welded.mergedVertices == 0);
  CHECK(buildSurface(welded.mesh).summary.components == 4);
}

TEST_CASE("faces without area are gone, and their corners bound nothing") {
  const PolygonMesh mesh = meshOf(kSquare, {{0, 1, 2}, {0, 2, 2}, {0, 2, 3}, {1, 1, 1}});
  const WeldedMesh welded = weld(mesh);
  CHECK(welded.collapsedFaces == std::vector<std::uint32_t>{1, 3});
  CHECK(welded.inputFace == IdVector<PolygonFace, InputFace>{InputFace(0), InputFace(2)});
  CHECK(buildSurface(welded.mesh).summary.disk.ok());
  for (const InputCorner c : welded.cornerFor.ids()) {
    const bool isGone = (c >= 3 && c < 6) || c >= 9;
    CHECK(welded.cornerFor[c].exists() != isGone);
    if (!isGone) CHECK(welded.inputCorner[welded.cornerFor[c]] == c);
  }
}

TEST_CASE("a face that touches itself stays one, with a vertex for each corner") {
  std::vector<double> positions = kSquare;
  positions.insert(positions.end(), {-1, 0, 0, -1, -1, 0});
  const PolygonMesh mesh = meshOf(positions, {{0, 1, 2, 0, 4, 5}});
  const WeldedMesh welded = weld(mesh);
  CHECK(welded.splitFaces == std::vector<std::uint32_t>{0});
  CHECK(welded.mesh.faceCount() == 1);
  CHECK(std::count(welded.cornerFor.begin(), welded.cornerFor.end(), kNone) == 0);
  const MeshSummary summary = buildSurface(welded.mesh).summary;
  CHECK(summary.disk.ok());
  CHECK(summary.degenerateFaces == 0);
  // A corner that is listed twice in a row does not mean that a face touches itself.
  const WeldedMesh doubled = weld(meshOf(kSquare, {{0, 1, 1, 2, 3}}));
  CHECK(doubled.mesh.faceVertices.size() == 4);
}

TEST_CASE("faces beside one that touches itself stay joined with it") {
  // The centre of a disk of ten triangles; the first and the sixth are one polygon.
  constexpr std::uint32_t n = 10;
  std::vector<double> p{0, 0, 0};
  for (std::uint32_t i = 0; i < n; ++i) {
    const double a = 6.283185307179586 * i / n;
    p.insert(p.end(), {std::cos(a), std::sin(a), 0.2 * std::sin(2 * a)});
  }
  std::vector<std::vector<std::uint32_t>> faces{{0, 1, 2, 0, 6, 7}};
  for (std::uint32_t i = 0; i < n; ++i)
    if (i != 0 && i != 5) faces.push_back({0, 1 + i, 1 + (i + 1) % n});
  const WeldedMesh welded = weld(meshOf(p, faces));
  const MeshSummary summary = buildSurface(welded.mesh).summary;
  CHECK(summary.disk.ok());
  CHECK(summary.boundaryEdges == n);
  CHECK(summary.vertices - summary.unreferencedVertices == n + 2);  // two at the centre
}

TEST_CASE("repeated faces are layers, whichever way they face") {
  const WeldedMesh sheet = weld(meshOf(kSquare, {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}}));
  CHECK(sheet.duplicateFaces == std::vector<std::array<std::uint32_t, 2>>{{2, 0}, {3, 1}});
  const MeshSummary summary = buildSurface(sheet.mesh).summary;
  CHECK(summary.nonManifoldEdges == 0);
  CHECK(summary.components == 2);
  CHECK(summary.boundaryLoops == 2);

  const WeldedMesh pile = weld(meshOf(
      kSquare, std::vector<std::vector<std::uint32_t>>(2000, std::vector<std::uint32_t>{0, 1, 2})));
  CHECK(pile.duplicateFaces.size() == 1999);
  CHECK(buildSurface(pile.mesh).summary.components == 2000);
}

TEST_CASE("a face of many corners at two places collapses") {
  std::vector<std::uint32_t> back(100000);
  for (std::size_t i = 0; i < back.size(); ++i) back[i] = i % 2;
  const WeldedMesh welded = weld(meshOf(kSquare, {{0, 1, 2}, back}));
  CHECK(welded.collapsedFaces == std::vector<std::uint32_t>{1});
}

TEST_CASE("the ends of edges without length are one, and a cut between them stays") {
  // A pole with one vertex for each face around it, some of them as far apart as a sine of pi.
  constexpr std::uint32_t n = 7;
  for (const double apart : {0.0, 1e-17, 1e-5}) {
    std::vector<double> p;
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t i = 0; i <= n; ++i) p.insert(p.end(), {i * apart, 0, 1});
    for (std::uint32_t i = 0; i <= n; ++i) {
      const double a = 6.283185307179586 * (i % n) / n;
      p.insert(p.end(), {std::cos(a), std::sin(a), 0});
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      faces.push_back({i, n + 1 + i, i + 1});
      faces.push_back({i + 1, n + 1 + i, n + 2 + i});
    }
    const PolygonMesh mesh = meshOf(p, faces);
    REQUIRE(buildSurface(mesh).summary.disk.ok());
    const WeldedMesh welded = weld(mesh, false);
    const Surface surface = buildSurface(welded.mesh);
    CHECK(surface.summary.disk.ok());
    CHECK(welded.mergedVertices == (apart < 1e-12 ? n : 0));
    CHECK(welded.collapsedFaces.size() == (apart < 1e-12 ? n : 0));
    CHECK(surface.summary.triangles == (apart < 1e-12 ? n : 2 * n));
  }
}

TEST_CASE("edges that are short beside one of their faces only stay") {
  // The first vertex is far away from the small square.
  const std::vector<double> p{0, 0, 1e15, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const WeldedMesh welded = weld(meshOf(p, {{0, 2, 1}, {0, 3, 2}, {1, 2, 3}, {1, 3, 4}}), false);
  CHECK(welded.mergedVertices == 0);
  CHECK(welded.mesh.faceCount() == 4);
}

TEST_CASE("many edges too short to be seen stay a curve") {
  // A square with a corner that is cut off, in steps of a ten-millionth.
  constexpr unsigned kSteps = 200;
  constexpr double kStep = 1e-7;
  PolygonMesh mesh;
  mesh.positions = {1, 0, 0, 1, 1, 0, 0, 1, 0};
  for (unsigned i = 0; i <= kSteps; ++i)
    mesh.positions.insert(mesh.positions.end(), {i * kStep, (kSteps - i) * kStep, 0});
  mesh.faceVertices = {0, 1, 2};
  for (unsigned i = 0; i <= kSteps; ++i) mesh.faceVertices.push_back(3 + i);
  mesh.faceOffsets = {0, static_cast<std::uint32_t>(mesh.faceVertices.size())};
  const WeldedMesh welded = weld(mesh, false);
  REQUIRE(welded.mesh.faceCount() == 1);
  const std::vector<std::uint32_t>& corners = welded.mesh.faceVertices;
  CHECK(corners.size() < kSteps);
  for (std::size_t i = 3; i + 1 < corners.size(); ++i) {
    const double x = welded.mesh.positions[3 * std::size_t{corners[i]}];
    const double next = welded.mesh.positions[3 * std::size_t{corners[i + 1]}];
    CHECK(next - x < 5 * kStep);
  }
}
