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
  for (const std::uint32_t h : chart.boundary) {
    const std::size_t v = chart.vertexOfCorner[h];
    out.insert(out.end(), {uv[2 * v], uv[2 * v + 1]});
  }
  return out;
}

double boundaryAngle(const DiskChart& chart, const std::vector<double>& uv, std::uint32_t h) {
  double sum = 0;
  for (std::uint32_t c = h; c != kNone; c = rotateCounterClockwise(chart.twin, c))
    sum += angleAt(&uv[2 * chart.vertexOfCorner[c]], &uv[2 * chart.vertexOfCorner[nextCorner(c)]],
                   &uv[2 * chart.vertexOfCorner[prevCorner(c)]]);
  return sum;
}

Validity checkValidity(const DiskChart& chart, const std::vector<double>& uv) {
  Validity out;
  for (std::uint32_t f = 0; f < chart.triangleCount(); ++f) {
    const std::uint32_t* v = &chart.vertexOfCorner[3 * f];
    const bool degenerate = isDegenerate(chart.angles[f]);
    out.degenerateTriangles += degenerate && f < chart.surfaceTriangles();
    bool finite = true;
    for (std::size_t k = 0; k < 3; ++k)
      finite = finite && std::isfinite(uv[2 * v[k]]) && std::isfinite(uv[2 * v[k] + 1]);
    const int sign = finite ? orientation(&uv[2 * v[0]], &uv[2 * v[1]], &uv[2 * v[2]]) : -1;
    if (sign < 0 || (sign == 0 && !degenerate)) ++out.flippedTriangles;
  }
  out.crossings = findCrossings(boundaryUv(chart, uv));
  for (const std::uint32_t h : chart.boundary)
    out.maxBoundaryAngle = std::max(out.maxBoundaryAngle, boundaryAngle(chart, uv, h));
  return out;
}

}  // namespace abflat
