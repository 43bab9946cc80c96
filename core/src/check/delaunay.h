#pragma once

#include <vector>

#include "chart/disk_chart.h"

namespace abflat {

/// Interior edges of a layout that are not locally Delaunay: the vertex opposite in one triangle
/// lies inside the other's circumcircle, by an exact predicate on the coordinates, or one of the
/// two triangles is not positively oriented.
struct DelaunayCheck {
  std::size_t edges = 0;              ///< interior edges
  std::vector<ChartCorner> violated;  ///< one half-edge per violated edge
};
DelaunayCheck checkDelaunay(const DiskChart& chart, const std::vector<double>& uv);

}  // namespace abflat
