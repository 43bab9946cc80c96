#include "unwrap/chart_shapes.h"

#include <cmath>
#include <vector>

#include "base/constants.h"
#include "base/point2.h"
#include "mesh/triangle_geometry.h"
#include "pack/outline.h"
#include "pack/pose.h"

namespace abflat {
namespace {

using Polygon = std::vector<PlanePoint>;

Polygon outlineOf(const ChartTopology& chart, const std::vector<double>& uv) {
  Polygon out;
  out.reserve(chart.boundary.size());
  for (const ChartCorner h : chart.boundary) {
    const auto [x, y] = pointAt(uv, chart.vertexOfCorner[h]);
    out.push_back({x, y});
  }
  return out;
}

double lengthOf(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += distance(polygon[i], polygon[(i + 1) % polygon.size()]);
  return sum;
}

ChartShape shapeOf(const ChartTopology& chart, const std::vector<double>& uv) {
  constexpr double kRound = 0.94;  // a regular octagon is, a hexagon is not
  constexpr double kAsWide = 1.15, kNearlyAll = 0.97, kLong = 3;
  const Polygon outline = outlineOf(chart, uv);
  if (outline.empty()) return ChartShape::Other;  // a given island may be closed
  const double area = massOf(outline).area, length = lengthOf(outline);
  const Pose box = leastBoxPose(convexHull(outline));
  const double ratio = box.width / box.height;
  const bool isRound = 4 * kPi * area >= kRound * length * length && ratio <= kAsWide;
  if (isRound && chart.filledHoles <= 1)
    return chart.filledHoles == 1 ? ChartShape::Ring : ChartShape::Disc;
  if (chart.filledHoles > 0 || !(area >= kNearlyAll * box.width * box.height))
    return ChartShape::Other;
  return ratio >= kLong ? ChartShape::Strip : ChartShape::Rectangle;
}

}  // namespace

void nameShapes(const ChartSet& set, FlatCharts& flat) {
  for (const ChartId i : set.ids())
    flat[i].shape = flat[i].problem.empty() && !flat[i].unpacked.empty()
                        ? shapeOf(set.topology(i), flat[i].unpacked)
                        : ChartShape::Other;
}

}  // namespace abflat
