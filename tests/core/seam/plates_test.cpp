#include "seam/plates.h"

#include <algorithm>

#include "abflat/unwrap.h"
#include "catch.h"
#include "mesh/surface.h"
#include "support/closed_meshes.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Number of edges of the borders of plates.
std::size_t borderEdges(const PolygonMesh& mesh) {
  const Surface surface = buildSurface(mesh);
  const SeamMesh seamMesh = makeSeamMesh(mesh.positions, surface.table, surface.fans);
  const Seams borders = plateBorders(seamMesh);
  return static_cast<std::size_t>(std::count(borders.begin(), borders.end(), 1)) / 2;
}

}  // namespace

TEST_CASE("the borders of a plate are the rims of its holes and its own") {
  for (const unsigned n : {1u, 2u, 3u, 5u})
    CHECK(borderEdges(grille(n, 0.5)) == 2 * (4 * n * n + 4 * (2 * n + 1)));
}

TEST_CASE("what is curved or has no hole is no plate") {
  CHECK(borderEdges(squares(4, 4, [](auto, auto) { return true; })) == 0);
  CHECK(borderEdges(torus(24, 12)) == 0);
  CHECK(borderEdges(bumpyGrid(8, 8, 0.1, 1)) == 0);
}

TEST_CASE("no border of a plate runs through a polygon") {
  const unsigned n = 3, row = 2 * n + 2;
  for (unsigned lifted = 0; lifted < row * row; ++lifted) {
    PolygonMesh mesh = grille(n, 0.5);
    mesh.positions[3 * lifted + 2] -= 0.7;
    const Surface surface = buildSurface(mesh);
    const auto& isDiagonal = surface.triangulation.isDiagonal;
    const SeamMesh seamMesh = makeSeamMesh(mesh.positions, surface.table, surface.fans, isDiagonal);
    const Seams borders = plateBorders(seamMesh);
    std::size_t diagonals = 0;
    for (const SurfaceCorner h : borders.ids()) diagonals += borders[h] && isDiagonal[h];
    CHECK(diagonals == 0);
  }
}

TEST_CASE("front and back of a grille are a chart each", "[unwrap]") {
  const unsigned n = 8;
  const Result<UnwrapResult> r = unwrap(grille(n, 0.5), {});
  REQUIRE(r.ok());
  CHECK(r.value().report.valid);
  // Beside them the walls of each hole, and the outer ones in one or two parts.
  CHECK(r.value().report.charts.size() <= n * n + 4);
  const std::size_t front = (2 * n + 1) * (2 * n + 1) - n * n;
  std::size_t whole = 0;
  for (const UnwrapChart& chart : r.value().report.charts) whole += chart.faces == 2 * front;
  CHECK(whole == 2);
}

TEST_CASE("a plate that is hardly any of the surface is left alone") {
  PolygonMesh mesh = grille(3, 0.5);
  const std::size_t alone = borderEdges(mesh);
  REQUIRE(alone > 0);
  for (const double side : {10., 1000.}) {
    PolygonMesh both = mesh;
    const auto first = static_cast<std::uint32_t>(both.vertexCount());
    both.positions.insert(both.positions.end(), {0, 0, 9, side, 0, 9, 0, side, 9});
    both.faceVertices.insert(both.faceVertices.end(), {first, first + 1, first + 2});
    both.faceOffsets.push_back(static_cast<std::uint32_t>(both.faceVertices.size()));
    CHECK(borderEdges(both) == (side < 100 ? alone : 0));
  }
}
