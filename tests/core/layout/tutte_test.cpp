#include "layout/tutte.h"

#include <algorithm>
#include <random>

#include "boundary/missed_angles.h"
#include "boundary/straight_runs.h"
#include "catch.h"
#include "check/validity.h"
#include "mesh/triangle_geometry.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Runs of any length at random places, as long as they can be straight.
StraightPlaces randomRuns(const DiskChart& chart, unsigned seed) {
  std::mt19937 numbers(seed);
  const auto random = [&numbers] { return static_cast<unsigned>(numbers()); };
  const auto n = static_cast<unsigned>(chart.boundary.size());
  for (;;) {
    StraightPlaces out(n, 0);
    for (unsigned runs = 1 + random() % 4; runs > 0; --runs) {
      const unsigned first = random() % n, count = 1 + random() % (n - 4);
      for (unsigned k = 0; k < count; ++k) out[BoundaryIndex((first + k) % n)] = 1;
    }
    if (!isTooStraight(out) && flatChords(chart, out).empty()) return out;
  }
}

PolygonMesh withoutVertex(const PolygonMesh& mesh, std::uint32_t vertex) {
  std::vector<std::uint32_t> corners;
  for (std::size_t c = 0; c < mesh.faceVertices.size(); c += 3) {
    const std::uint32_t* face = &mesh.faceVertices[c];
    if (std::find(face, face + 3, vertex) == face + 3)
      corners.insert(corners.end(), face, face + 3);
  }
  return makeTriangleMesh(mesh.positions, std::move(corners));
}

}  // namespace

TEST_CASE("Tutte's embedding keeps runs straight and has the area of the surface") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const DiskChart chart = chartOf(bumpyGrid(3 + seed % 9, 4 + seed % 5, 0.5, seed));
    const StraightPlaces straight = randomRuns(chart, seed);
    for (const double weight : {1.0, 0.1, 1e-3}) {
      const Embedding e = embedTutte(chart, straight, weight);
      INFO("seed " << seed << ", weight " << weight);
      REQUIRE(e.problem.empty());
      CHECK(bentPlaces(chart, e.uv, straight).count == 0);
      CHECK(checkValidity(chart, e.uv).valid());
      const BoundaryBounds convex(chart.boundary.size(), 1);
      CHECK(exceededBounds(chart, e.uv, convex).count == 0);
    }
  }
}

TEST_CASE("lighter edges to the boundary keep triangles of a folded strip apart") {
  const PolygonMesh strip =
      withoutVertex(bumpyGrid(60, 3, 0, 1), 60);  // has an edge across its corner
  const DiskChart chart = chartOf(strip);
  // All but one short side of the strip.
  StraightPlaces straight(chart.boundary.size(), 1);
  for (const BoundaryIndex i : straight.ids())
    if (chart.inputVertex[chart.boundaryVertex(i)] % 61 == 0) straight[i] = 0;
  REQUIRE(placesThatTurn(chart, straight) == 4);
  REQUIRE(flatChords(chart, straight).empty());
  CHECK_FALSE(checkValidity(chart, embedTutte(chart, straight, 1).uv).valid());
  CHECK(checkValidity(chart, embedTutte(chart, straight, 1e-2).uv).valid());
}
