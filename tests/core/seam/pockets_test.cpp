#include "seam/pockets.h"

#include <algorithm>
#include <map>
#include <utility>

#include "catch.h"
#include "support/cut_meshes.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// A grid with folds along the diagonals of some squares: each of the two triangles there goes on
/// straight beyond the diagonal, and two more triangles join what is beyond. So two edges join the
/// ends of the diagonal.
PolygonMesh foldedGrid(unsigned size, const std::vector<std::uint32_t>& squares) {
  PolygonMesh mesh = bumpyGrid(size, size, 0.3, 1);
  std::vector<double>& p = mesh.positions;
  for (const std::uint32_t square : squares) {
    std::uint32_t* t = &mesh.faceVertices[6 * square];
    while (std::count(t + 3, t + 6, t[2]) > 0) std::rotate(t, t + 1, t + 3);
    const std::uint32_t a = t[0], b = t[1];
    const auto isOpposite = [&](std::uint32_t v) { return v != a && v != b; };
    const auto u = static_cast<std::uint32_t>(p.size() / 3), v = u + 1;
    for (const std::uint32_t from : {t[2], *std::find_if(t + 3, t + 6, isOpposite)})
      for (std::size_t k = 0; k < 3; ++k)
        p.push_back(0.75 * (p[3 * a + k] + p[3 * b + k]) - 0.5 * p[3 * from + k]);
    mesh.faceVertices.insert(mesh.faceVertices.end(), {b, a, u, a, b, v, a, v, u, b, u, v});
  }
  return makeTriangleMesh(mesh.positions, mesh.faceVertices);
}

/// Whether all edges of a chart join other vertices than its other edges do.
bool isSimple(const PolygonMesh& chart) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (std::size_t i = 0; i < chart.faceVertices.size(); ++i) {
    const std::uint32_t a = chart.faceVertices[i];
    const std::uint32_t b = chart.faceVertices[i % 3 == 2 ? i - 2 : i + 1];
    if (++sides[{a, b}] > 1) return false;
  }
  return true;
}

bool areSimple(const std::vector<PolygonMesh>& charts) {
  return std::all_of(charts.begin(), charts.end(), isSimple);
}

}  // namespace

TEST_CASE("a mesh whose edges all join other vertices has no pockets", "[seams]") {
  for (const PolygonMesh& mesh : {bumpyGrid(9, 7, 0.3, 1), torus(8, 6)})
    CHECK(doubledEdges(Cuttable(mesh).seamMesh).empty());
}

TEST_CASE("pockets are cut into, and nothing else", "[seams]") {
  for (const std::vector<std::uint32_t>& squares :
       {std::vector<std::uint32_t>{60}, {0}, {55, 56, 99}, {9, 90, 44}}) {
    const Cuttable c(foldedGrid(10, squares));
    const std::vector<SurfaceCorner> doubled = doubledEdges(c.seamMesh);
    REQUIRE(doubled.size() == 4 * squares.size());
    Seams seams(c.seamMesh.twin.size(), 0);
    REQUIRE_FALSE(areSimple(chartsOf(c, seams)));
    openPockets(c.seamMesh, doubled, seams);
    const std::vector<PolygonMesh> charts = chartsOf(c, seams);
    CHECK(charts.size() == 1);
    CHECK(areSimple(charts));
    const Seams once = seams;
    openPockets(c.seamMesh, doubled, seams);
    CHECK(seams == once);
  }
}

TEST_CASE("charts that are found have no pockets", "[seams]") {
  const auto check = [](const PolygonMesh& mesh) {
    const Cuttable c(mesh);
    SeamOptions options;
    const Seams seams = findSeams(c.seamMesh, Seams(c.seamMesh.twin.size(), 0), options, nullptr);
    CHECK(areSimple(chartsOf(c, seams)));
  };
  check(foldedGrid(10, {7, 33, 55, 70}));
  if (const PolygonMesh shared = sharedMesh("beetle-nonmanifold.obj"); shared.faceCount() > 0)
    check(shared);
}
