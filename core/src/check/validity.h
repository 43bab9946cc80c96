#pragma once

#include <vector>

#include "chart/disk_chart.h"
#include "check/crossings.h"

namespace abflat {

/// uv of the boundary's vertices, in order.
std::vector<double> boundaryUv(const DiskChart& chart, const std::vector<double>& uv);

/// Interior angle of the layout, radians, at the boundary vertex that half-edge h of the boundary
/// leaves.
double boundaryAngle(const DiskChart& chart, const std::vector<double>& uv, ChartCorner h);

/// Whether a layout is a valid, injective map, decided with exact predicates on the coordinates
/// alone.
///
/// All triangles positively oriented and a simple boundary make the map injective: the number of
/// triangles over a point equals the boundary's winding number there, which is 0 or 1. Triangles of
/// zero area in 3D may have none in uv. With what fills holes the map is one of a larger disk, and
/// injective on the surface as on all of it.
struct Validity {
  std::size_t degenerateTriangles = 0;  ///< of zero area in 3D
  std::size_t flippedTriangles = 0;     ///< not positively oriented, or not finite
  Crossings crossings;                  ///< of the boundary, edges numbered along chart.boundary
  double maxBoundaryAngle = 0;          ///< largest interior angle at a boundary vertex, radians

  bool valid() const { return flippedTriangles == 0 && crossings.count == 0; }
};
Validity checkValidity(const DiskChart& chart, const std::vector<double>& uv);

}  // namespace abflat
