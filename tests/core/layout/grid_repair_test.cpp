#include "layout/grid_repair.h"

#include <cmath>
#include <random>

#include "catch.h"
#include "check/validity.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// A flat grid as a chart, with some inner vertices pulled so close to a neighbour that the
/// triangles between them are far thinner than `step`.
struct Needles {
  DiskChart chart;
  std::vector<double> uv;
};

Needles needles(unsigned side, std::size_t every, double gap, unsigned seed) {
  const PolygonMesh flat = bumpyGrid(side, side, 0, seed);
  Needles out;
  out.chart = makeDiskChart(flat, buildSurface(flat));
  for (const ChartVertex v : out.chart.vertices())
    for (std::size_t d = 0; d < 2; ++d)
      out.uv.push_back(out.chart.positions[3 * v + d] * 0.3 + 0.3);
  std::vector<bool> isUsed(out.chart.vertexCount(), false);
  for (const ChartCorner h : out.chart.boundary) isUsed[out.chart.vertexOfCorner[h]] = true;
  for (const ChartCorner c : out.chart.corners()) {
    if (c % every != 0) continue;
    const ChartVertex v = out.chart.vertexOfCorner[c];
    const ChartVertex w = out.chart.vertexOfCorner[nextCorner(c)];
    if (isUsed[v] || isUsed[w]) continue;
    std::vector<double> moved = out.uv;
    for (std::size_t d = 0; d < 2; ++d)
      moved[2 * v + d] = out.uv[2 * w + d] + gap * (out.uv[2 * v + d] - out.uv[2 * w + d]);
    if (!checkValidity(out.chart, moved).valid()) continue;
    isUsed[v] = isUsed[w] = true;
    out.uv = moved;
  }
  return out;
}

void roundTo(double step, std::vector<double>& uv) {
  for (double& x : uv) x = std::floor(x / step + 0.5) * step;
}

}  // namespace

TEST_CASE("triangles thinner than the grid get area, and vertices stay close", "[certificate]") {
  constexpr double kStep = 0x1p-24;
  int repaired = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Needles n = needles(12, 5, 1e-9, seed);
    REQUIRE(checkValidity(n.chart, n.uv).valid());
    const std::vector<double> exact = n.uv;
    roundTo(kStep, n.uv);
    if (checkValidity(n.chart, n.uv).valid()) continue;
    const std::vector<double> before = n.uv;
    const GridRepair repair = repairOnGrid(n.chart, exact, kStep, n.uv);
    CHECK(repair.isValid);
    CHECK(checkValidity(n.chart, n.uv).valid());
    CHECK(repair.moved > 0);
    CHECK(repair.farthest <= 12 * kStep);
    std::size_t moved = 0;
    for (const ChartVertex v : n.chart.vertices()) {
      for (std::size_t d = 0; d < 2; ++d) {
        CHECK(std::abs(n.uv[2 * v + d] - before[2 * v + d]) <= repair.farthest);
        CHECK(std::floor(n.uv[2 * v + d] / kStep) == n.uv[2 * v + d] / kStep);
      }
      moved += n.uv[2 * v] != before[2 * v] || n.uv[2 * v + 1] != before[2 * v + 1];
    }
    CHECK(moved == repair.moved);
    ++repaired;
  }
  CHECK(repaired > 10);
}

TEST_CASE("what is valid stays as it is", "[certificate]") {
  Needles n = needles(8, 1000000, 1, 1);
  roundTo(0x1p-24, n.uv);
  const std::vector<double> before = n.uv;
  const GridRepair repair = repairOnGrid(n.chart, before, 0x1p-24, n.uv);
  CHECK(repair.isValid);
  CHECK(repair.moved == 0);
  CHECK(n.uv == before);
}
