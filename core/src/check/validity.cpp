#include "check/validity.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "exact/orientation.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

double angleAt(const double* o, const double* a, const double* b) {
  const double ux = a[0] - o[0], uy = a[1] - o[1], vx = b[0] - o[0], vy = b[1] - o[1];
  return portable::atan2(std::abs(ux * vy - uy * vx), ux * vx + uy * vy);
}

}  // namespace

std::vector<double> boundaryUv(const DiskChart& chart, const std::vector<double>& uv) {
  std::vector<double> out;
  out.reserve(2 * chart.boundary.size());
  for (const ChartCorner h : chart.boundary) {
    const ChartVertex v = chart.vertexOfCorner[h];
    out.insert(out.end(), {uv[2 * v], uv[2 * v + 1]});
  }
  return out;
}

double boundaryAngle(const DiskChart& chart, const std::vector<double>& uv, ChartCorner h) {
  double sum = 0;
  for (ChartCorner c = h; c.exists(); c = rotateCounterClockwise(chart.twin, c))
    sum += angleAt(&uv[2 * chart.vertexOfCorner[c]], &uv[2 * chart.vertexOfCorner[nextCorner(c)]],
                   &uv[2 * chart.vertexOfCorner[prevCorner(c)]]);
  return sum;
}

Validity checkValidity(const DiskChart& chart, const std::vector<double>& uv) {
  Validity out;
  for (const ChartTriangle f : chart.triangles()) {
    const auto [a, b, c] = pointsOf(uv, verticesOf(chart.vertexOfCorner, f));
    const bool degenerate = isDegenerate(chart.angles[f]);
    out.degenerateTriangles += degenerate && f < chart.surfaceTriangles().size();
    bool finite = true;
    for (const double* p : {a, b, c}) finite = finite && std::isfinite(p[0]) && std::isfinite(p[1]);
    const int sign = finite ? orientation(a, b, c) : -1;
    if (sign < 0 || (sign == 0 && !degenerate)) ++out.flippedTriangles;
  }
  out.crossings = findCrossings(boundaryUv(chart, uv));
  for (const ChartCorner h : chart.boundary)
    out.maxBoundaryAngle = std::max(out.maxBoundaryAngle, boundaryAngle(chart, uv, h));
  return out;
}

}  // namespace abflat
