#pragma once

#include "mesh/surface_map.h"
#include "mesh/triangle_geometry.h"

namespace abflat {

/// Unit normal of a triangle, zero if it has no area.
Vec3 facetNormal(const SurfaceMap& map, SurfaceTriangle f);

/// Angle between normals, in degrees; 0 if there is none.
double bendBetween(const Vec3& a, const Vec3& b);

}  // namespace abflat
