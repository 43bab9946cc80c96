#include "reference/lscm.h"

#include "base/point2.h"
#include "mesh/triangle_geometry.h"
#include "pin/relax_conformally.h"
#include "reference/corner_angles.h"

namespace abflat {
namespace {

double squaredDistance(const DiskChart& chart, ChartVertex v, const Vec3& p) {
  double sum = 0;
  for (std::size_t d = 0; d < 3; ++d) {
    const double x = chart.positions[3 * v + d] - p[d];
    sum += x * x;
  }
  return sum;
}

ChartVertex farthestFrom(const DiskChart& chart, const Vec3& p) {
  ChartVertex best = chart.boundaryVertex(BoundaryIndex(0));
  for (const ChartCorner h : chart.boundary) {
    const ChartVertex v = chart.vertexOfCorner[h];
    if (squaredDistance(chart, v, p) > squaredDistance(chart, best, p)) best = v;
  }
  return best;
}

Vec3 positionOf(const DiskChart& chart, ChartVertex v) {
  return {chart.positions[3 * v], chart.positions[3 * v + 1], chart.positions[3 * v + 2]};
}

}  // namespace

std::array<ChartVertex, 2> findPins(const DiskChart& chart) {
  Vec3 middle{0, 0, 0};
  for (const ChartCorner h : chart.boundary)
    for (std::size_t d = 0; d < 3; ++d)
      middle[d] += chart.positions[3 * chart.vertexOfCorner[h] + d] /
                   static_cast<double>(chart.boundary.size());
  const ChartVertex first = farthestFrom(chart, middle);
  return {first, farthestFrom(chart, positionOf(chart, first))};
}

Embedding embedLscm(const DiskChart& chart) {
  Embedding out{std::vector<double>(2 * chart.vertices().size(), 0), {}};
  const auto [left, right] = findPins(chart);
  if (left == right) {
    out.problem = "all boundary vertices coincide, so there is nothing to pin";
    return out;
  }
  setPoint(out.uv, right, {1, 0});
  FactorMemory unlimited;
  if (!relaxConformally({chart.vertexOfCorner, chart.boundary}, drawableAngles(chart).raw(),
                        {left, right}, out.uv, unlimited))
    out.problem =
        "the linear system of the conformal energy cannot be solved: it is "
        "numerically singular";
  return out;
}

}  // namespace abflat
