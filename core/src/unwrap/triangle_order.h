#pragma once

#include "mesh/surface_map.h"

namespace abflat {

/// A triangle of UnwrapResult::triangles.
using OutputTriangle = Id<struct OutputTriangleTag>;

/// Where each triangle of the surface is among those of the result, which are ordered by input
/// face. A face with nothing left on the surface is folded; it gets triangles of its own.
struct TriangleOrder {
  IdVector<SurfaceTriangle, OutputTriangle> ofTriangle;
  IdVector<InputFace, OutputTriangle> firstOfFace;  ///< ends with the total
  IdVector<InputFace, std::uint8_t> isFolded;
};
TriangleOrder triangleOrder(const SurfaceMap& map);

}  // namespace abflat
