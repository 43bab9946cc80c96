#pragma once

#include <cstdint>
#include <vector>

#include "pack/pack.h"

namespace abflat {

struct PlanePoint {
  double x = 0, y = 0;
};

/// Closed polygons one after the other, in groups. What has a winding number other than 0 in a
/// group is covered.
struct Loops {
  std::vector<PlanePoint> points;
  std::vector<std::uint32_t> ends;    ///< index behind each loop's last point
  std::vector<std::uint8_t> isGroup;  ///< per loop: it is the last one of its group
};

/// Loops that cover all of a shape, whatever its triangles are like: a triangle that is not
/// positively oriented has a group of its own, since it may cancel others in the outline's winding.
/// Where the shape has no outline, that of its other triangles, holes included.
Loops coveringLoops(const PackShape& shape);

struct Mass {
  double area = 0;  ///< of all triangles together, whichever way they are turned
  PlanePoint center;
};
Mass massOf(const PackShape& shape);
/// Of what a counter-clockwise polygon bounds.
Mass massOf(const std::vector<PlanePoint>& polygon);

/// Strictly convex, counter-clockwise; one or two points when all lie in a point or on a line.
std::vector<PlanePoint> convexHull(std::vector<PlanePoint> points);

}  // namespace abflat
