#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "islands/mapped_triangles.h"
#include "verify/measure_islands.h"

namespace abflat {

/// Two islands that overlap, or one that overlaps itself, and two triangles that show it.
struct IslandOverlap {
  std::array<std::uint32_t, 2> islands;  ///< the smaller number first
  std::array<std::uint32_t, 2> triangles;
  bool isStacked = false;  ///< they cover the same place

  bool isOwn() const { return islands[0] == islands[1]; }
};

struct FoundOverlaps {
  std::vector<IslandOverlap> pairs;       ///< by islands
  std::vector<std::uint8_t> overlapping;  ///< per triangle
  std::vector<std::uint8_t> isOnAnother;  ///< per island: stacked on one of a smaller number
};

/// Decided exactly, but whether two islands cover the same place: their boxes differ by less than
/// half a texel, and their areas by less than a hundredth. `island`: per triangle.
FoundOverlaps findOverlaps(const MappedTriangles& triangles,
                           const std::vector<std::uint32_t>& island, const LayoutMeasures& measures,
                           const AtlasSize& size);

}  // namespace abflat
