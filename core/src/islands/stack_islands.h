#pragma once

#include <cstdint>
#include <vector>

#include "base/listener.h"
#include "islands/island_triangles.h"

namespace abflat {

/// Which islands lie on each other on purpose.
struct IslandStacks {
  std::vector<std::uint32_t> first;          ///< per island, the first one of its stack
  std::vector<std::uint8_t> overlapsOthers;  ///< per island: slightly, one of another stack
};

/// Per island, the materials that it has, in ascending order.
using IslandMaterials = std::vector<std::vector<std::uint32_t>>;

/// Puts islands on one stack that have half of the smaller one or more in common, however they are
/// numbered, and a material. An island without area is on the stack of one that contains all its
/// points. `materials` is empty if they do not count. Incomplete once `listener` has stopped.
IslandStacks stackIslands(const IslandTriangles& triangles, const IslandMaterials& materials,
                          const Listener& listener);

}  // namespace abflat
