#include "check/delaunay.h"

#include "exact/in_circle.h"
#include "exact/orientation.h"

namespace abflat {

DelaunayCheck checkDelaunay(const DiskChart& chart, const std::vector<double>& uv) {
  DelaunayCheck out;
  const auto at = [&](ChartCorner corner) { return &uv[2 * chart.vertexOfCorner[corner]]; };
  const auto isPositive = [&](ChartCorner h) {
    return orientation(at(h), at(nextCorner(h)), at(prevCorner(h))) > 0;
  };
  for (const ChartCorner h : chart.corners()) {
    const ChartCorner twin = chart.twin[h];
    if (!twin.exists() || twin < h) continue;
    ++out.edges;
    if (!isPositive(h) || !isPositive(twin) ||
        inCircle(at(h), at(nextCorner(h)), at(prevCorner(h)), at(prevCorner(twin))) > 0)
      out.violated.push_back(h);
  }
  return out;
}

}  // namespace abflat
