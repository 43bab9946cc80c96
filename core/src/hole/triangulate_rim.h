#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/triangle_geometry.h"

namespace abflat {

/// A hole as it is seen along its mean normal, where its rim runs counter-clockwise.
struct Rim {
  std::vector<Vec3> points;
  std::vector<std::uint8_t> isCorner;  ///< only one triangle of the surface is there
  /// Whether an edge of the surface joins two of its places.
  std::function<bool(std::uint32_t, std::uint32_t)> isJoined;
};

/// Triangles, as places along the rim, that fill it; none where it is not a simple polygon from
/// there, or where a triangulation would use an edge twice or leave a vertex with two triangles:
/// the filled surface could not be drawn.
std::vector<std::array<std::uint32_t, 3>> triangulateRim(const Rim& rim);

}  // namespace abflat
