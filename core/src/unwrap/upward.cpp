#include "unwrap/upward.h"

namespace abflat {

Point2 upward(const ChartTopology& chart, const std::vector<double>& uv,
              const std::vector<double>& positions, std::size_t axis) {
  const auto heightOf = [&](ChartCorner c) {
    return positions[3 * std::size_t{chart.inputVertex[chart.vertexOfCorner[c]]} + axis];
  };
  const double zero = heightOf(ChartCorner(0));
  Point2 sum{};
  double area = 0;
  for (const ChartCorner c : chart.surfaceCorners()) {
    // Times the area, the gradient of a triangle is the sum of its heights, each times half of the
    // opposite side turned left.
    const Point2 p = pointAt(uv, chart.vertexOfCorner[c]);
    const Point2 a = pointAt(uv, chart.vertexOfCorner[nextCorner(c)]);
    const Point2 b = pointAt(uv, chart.vertexOfCorner[prevCorner(c)]);
    const double height = (heightOf(c) - zero) / 2;
    sum = {sum[0] + height * (a[1] - b[1]), sum[1] + height * (b[0] - a[0])};
    area += ((a[0] - p[0]) * (b[1] - p[1]) - (a[1] - p[1]) * (b[0] - p[0])) / 6;
  }
  if (!(area > 0)) return {};
  return {sum[0] / area, sum[1] / area};
}

}  // namespace abflat
