#pragma once

#include <cstdint>
#include <vector>

#include "abflat/generated/pack_options.h"
#include "islands/island_triangles.h"
#include "pack/pack.h"

namespace abflat {

/// Islands that move together, as packing sees them.
struct IslandStack {
  std::vector<std::uint32_t> islands;
  UvBox box;
  double coveredArea = 0;  ///< in uv; what is covered more than once counts once
  double uvArea = 0;       ///< of all triangles
  double surfaceArea = 0;  ///< in 3D
  double factor = 1;       ///< length in its shape per length along u
  double aspect = 1;       ///< of the texture that it was for; see AtlasSize
  bool isFixed = false;    ///< it stays where it is

  double middle(std::size_t axis) const { return (box.low[axis] + box.high[axis]) / 2; }
  /// Where uv are in its shape.
  double placed(double x, std::size_t axis) const {
    return (x - middle(axis)) * factor / (axis == 1 ? aspect : 1);
  }
};

/// The stacks, in an order that follows from the layout alone. `first`: per island, the first one
/// of its stack; `surfaceArea`: per island.
std::vector<IslandStack> listStacks(const IslandTriangles& triangles,
                                    const std::vector<std::uint32_t>& first,
                                    const std::vector<double>& surfaceArea);

/// a / b, or 0 unless both are positive.
inline double areaRatio(double a, double b) { return a > 0 && b > 0 ? a / b : 0; }

/// Gives shapes about the area of their surface, so that a texel density can be asked for. Returns
/// the factor that keeps the size of all stacks together.
double setFactors(IslandSizes sizes, std::vector<IslandStack>& stacks);

/// Its triangles around its middle, or where they are if they stay, all counter-clockwise, so that
/// what is mirrored or folded covers as much as anything else.
PackShape shapeOf(const IslandStack& stack, const IslandTriangles& triangles);

}  // namespace abflat
