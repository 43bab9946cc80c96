#include "unwrap/right_angled.h"

#include <cmath>

#include "base/point2.h"

namespace abflat {
namespace {

/// With twice the angle to the axis.
Point2 squared(const Point2& z) { return {z[0] * z[0] - z[1] * z[1], 2 * z[0] * z[1]}; }

}  // namespace

RightAngled rightAngled(const ChartTopology& topology, const std::vector<double>& uv) {
  RightAngled out;
  Point2 sum = {0, 0};
  for (const ChartCorner h : topology.boundary) {
    const Point2 a = pointAt(uv, topology.vertexOfCorner[h]),
                 b = pointAt(uv, topology.vertexOfCorner[nextCorner(h)]);
    const Point2 d = {b[0] - a[0], b[1] - a[1]};
    const double length = std::sqrt(d[0] * d[0] + d[1] * d[1]);
    if (!(length > 0)) continue;
    out.length += length;
    const Point2 turned = squared(squared({d[0] / length, d[1] / length}));
    for (const std::size_t k : {0, 1}) sum[k] += length * turned[k];
  }
  out.along = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1]);
  return out;
}

}  // namespace abflat
