#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "pack/pack.h"

namespace abflat {

struct PlanePoint {
  double x = 0, y = 0;
};

inline double distance(PlanePoint a, PlanePoint b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

/// Closed polygons, one after the other, in groups. A point is covered if it has a non-zero winding
/// number in some group.
struct Loops {
  std::vector<PlanePoint> points;
  std::vector<std::uint32_t> ends;    ///< index past each loop's last point
  std::vector<std::uint8_t> isGroup;  ///< per loop: whether it is the last one of its group
};

/// Loops that cover all of a shape, whatever its triangles are like. A triangle that is not
/// positively oriented gets a group of its own, since it may cancel others in the outline's
/// winding. If the shape has no outline, that of its other triangles is used, holes included.
Loops coveringLoops(const PackShape& shape);

struct Mass {
  double area = 0;  ///< sum over all triangles, whatever their orientation
  PlanePoint center;
};
Mass massOf(const PackShape& shape);
/// The mass of the area within a counter-clockwise polygon.
Mass massOf(const std::vector<PlanePoint>& polygon);

/// Strictly convex, counter-clockwise; one or two points if all coincide or are collinear.
std::vector<PlanePoint> convexHull(std::vector<PlanePoint> points);

}  // namespace abflat
