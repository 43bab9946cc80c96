#include "angle/angle_problem.h"

#include <cmath>
#include <numeric>

#include "base/constants.h"
#include "catch.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

TEST_CASE("targets sum to 2 pi inside and are the 3D angles on the boundary") {
  const PolygonMesh mesh = bumpyGrid(6, 5, 0.5, 1);
  const DiskChart chart = chartOf(mesh);
  const AngleProblem p = problemOf(chart, 1.2);
  IdVector<ChartVertex, double> sum(p.vertexCount(), 0), sum3d(p.vertexCount(), 0);
  for (const ChartCorner c : p.corners()) {
    const ChartVertex o = chart.vertexOfCorner[c], a = chart.vertexOfCorner[nextCorner(c)],
                      b = chart.vertexOfCorner[prevCorner(c)];
    double dot = 0, aa = 0, bb = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double u = chart.positions[3 * a + d] - chart.positions[3 * o + d];
      const double v = chart.positions[3 * b + d] - chart.positions[3 * o + d];
      dot += u * v, aa += u * u, bb += v * v;
    }
    const double alpha = std::acos(dot / std::sqrt(aa * bb));
    sum3d[o] += alpha;
    sum[o] += p.target[c];
    CHECK(p.weight[c] * p.target[c] * p.target[c] == Approx(1));
    if (p.isBoundary[o]) CHECK(p.target[c] == Approx(alpha));
  }
  for (const ChartVertex v : p.vertices()) {
    CHECK(sum[v] == Approx(p.isBoundary[v] ? sum3d[v] : 2 * kPi));
    CHECK(p.angleSum[v] == Approx(p.isBoundary[v] ? 1.2 * kPi : 2 * kPi));
  }
}

TEST_CASE("t of 2 and above leaves the boundary free") {
  for (double t : {2.0, 2.5}) {
    const AngleProblem p = problemOf(bumpyGrid(3, 3, 0.2, 1), t);
    for (const ChartVertex v : p.vertices())
      CHECK(std::isinf(p.angleSum[v]) == bool(p.isBoundary[v]));
  }
}

TEST_CASE("triangles of zero area get targets that can be drawn") {
  // A needle folded flat, and one with two corners at the same place.
  const PolygonMesh flat =
      makeTriangleMesh({0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 1, 0}, {0, 1, 2, 0, 2, 3});
  const PolygonMesh point =
      makeTriangleMesh({0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 1, 2, 0, 2, 3});
  for (const PolygonMesh& mesh : {flat, point}) {
    const AngleProblem p = problemOf(mesh, 2);
    for (double a : p.target) {
      CHECK(std::isfinite(a));
      CHECK(a > 0);
    }
    CHECK(std::accumulate(p.target.begin(), p.target.begin() + 3, 0.0) == Approx(kPi));
  }
}
