#include "check/delaunay.h"

#include "exact/in_circle.h"
#include "exact/orientation.h"

namespace abflat {

DelaunayCheck checkDelaunay(const DiskChart& chart, const std::vector<double>& uv) {
  DelaunayCheck out;
  const auto at = [&](std::uint32_t corner) { return &uv[2 * chart.vertexOfCorner[corner]]; };
  const auto isPositive = [&](std::uint32_t h) {
    return orientation(at(h), at(nextCorner(h)), at(prevCorner(h))) > 0;
  };
  for (std::uint32_t h = 0; h < chart.twin.size(); ++h) {
    const std::uint32_t twin = chart.twin[h];
    if (twin == kNone || twin < h) continue;
    ++out.edges;
    if (!isPositive(h) || !isPositive(twin) ||
        inCircle(at(h), at(nextCorner(h)), at(prevCorner(h)), at(prevCorner(twin))) > 0)
      out.violated.push_back(h);
  }
  return out;
}

}  // namespace abflat
