#pragma once

#include <vector>

#include "chart/disk_chart.h"
#include "check/crossings.h"

namespace abflat {

/// uv of the boundary's vertices, in order.
std::vector<double> boundaryUv(const DiskChart& chart, const std::vector<double>& uv);

/// Interior angle of the layout, in radians, at the boundary vertex where boundary half-edge h
/// starts.
double boundaryAngle(const DiskChart& chart, const std::vector<double>& uv, ChartCorner h);

/// Whether a layout is a valid, injective map, decided with exact predicates on the coordinates
/// alone.
///
/// Positively oriented triangles and a simple boundary make the map injective: the number of
/// triangles over a point equals the boundary's winding number there, which is 0 or 1. Triangles of
/// zero area in 3D may also have none in uv. Together with the triangles that fill holes the map is
/// that of a larger disk, and injective on the surface if it is on all of it.
struct Validity {
  std::size_t degenerateTriangles = 0;  ///< of zero area in 3D
  std::size_t flippedTriangles = 0;     ///< not positively oriented, or not finite
  Crossings crossings;                  ///< of the boundary, edges numbered along chart.boundary
  double maxBoundaryAngle = 0;          ///< largest interior angle at a boundary vertex, radians

  bool valid() const { return flippedTriangles == 0 && crossings.count == 0; }
};
Validity checkValidity(const DiskChart& chart, const std::vector<double>& uv);

}  // namespace abflat
