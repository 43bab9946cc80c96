#pragma once

#include "mesh/surface_map.h"

namespace abflat {

/// A triangle of UnwrapResult::triangles.
using OutputTriangle = Id<struct OutputTriangleTag>;

/// Where triangles of the surface are among those of the result, which go by faces of the input. A
/// face of which nothing is on the surface is folded; it has triangles of its own.
struct TriangleOrder {
  IdVector<SurfaceTriangle, OutputTriangle> ofTriangle;
  IdVector<InputFace, OutputTriangle> firstOfFace;  ///< ends with their count
  IdVector<InputFace, std::uint8_t> isFolded;
};
TriangleOrder triangleOrder(const SurfaceMap& map);

}  // namespace abflat
