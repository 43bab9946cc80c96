#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/ids.h"
#include "mesh/triangle_geometry.h"

namespace abflat {

/// Index of a point along a rim, and of the side that begins there.
using RimIndex = Id<struct RimTag>;

/// A hole seen along its mean normal, with its rim running counter-clockwise.
struct Rim {
  IdVector<RimIndex, Vec3> points;
  IdVector<RimIndex, std::uint8_t> isCorner;  ///< only one triangle of the surface is there
  /// Whether an edge of the surface joins two of its points.
  std::function<bool(RimIndex, RimIndex)> isJoined;
};

using RimTriangle = std::array<RimIndex, 3>;

/// Triangles that fill the hole. None if it is not a simple polygon as seen along the normal, or if
/// a triangulation would use an edge twice or leave a vertex with two triangles, since the filled
/// surface could not be drawn then.
std::vector<RimTriangle> triangulateRim(const Rim& rim);

}  // namespace abflat
