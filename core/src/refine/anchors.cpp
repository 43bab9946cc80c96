#include "refine/anchors.h"

#include <algorithm>

#include "base/point2.h"
#include "mesh/triangle_geometry.h"

namespace abflat {

Anchors anchorsOf(const DiskChart& chart, const std::vector<double>& uv,
                  const IdVector<ChartVertex, std::uint8_t>& isFixed) {
  Anchors out{isFixed, {}, {}};
  if (std::find(isFixed.begin(), isFixed.end(), 1) != isFixed.end()) return out;
  out.centre = chart.boundaryVertex(BoundaryIndex(0));
  out.isFixed.assign(chart.vertexCount(), 0);
  out.isFixed[out.centre] = 1;
  const Point2 centre = pointAt(uv, out.centre);
  double most = 0;
  for (const ChartVertex v : chart.vertices()) {
    const Point2 p = pointAt(uv, v);
    const double distance = norm(p[0] - centre[0], p[1] - centre[1]);
    if (distance <= most) continue;
    most = distance;
    out.arm = v;
  }
  return out;
}

}  // namespace abflat
