#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/ids.h"
#include "mesh/triangle_geometry.h"

namespace abflat {

/// Which point of a rim, counted along it. It also counts the sides, which begin at the points.
using RimIndex = Id<struct RimTag>;

/// A hole as it is seen along its mean normal, where its rim runs counter-clockwise.
struct Rim {
  IdVector<RimIndex, Vec3> points;
  IdVector<RimIndex, std::uint8_t> isCorner;  ///< only one triangle of the surface is there
  /// Whether an edge of the surface joins two of its points.
  std::function<bool(RimIndex, RimIndex)> isJoined;
};

using RimTriangle = std::array<RimIndex, 3>;

/// Triangles that fill it; none where it is not a simple polygon from
/// there, or where a triangulation would use an edge twice or leave a vertex with two triangles:
/// the filled surface could not be drawn.
std::vector<RimTriangle> triangulateRim(const Rim& rim);

}  // namespace abflat
