#pragma once

#include <cstdint>
#include <vector>

#include "mesh/corner_table.h"

namespace abflat {

/// Vertices of the surface as its triangles see them: one per fan of triangles that share edges at
/// an input vertex. A vertex where the surface touches itself has several. Numbered by input
/// vertex, then by first corner.
struct Fans {
  std::vector<std::uint32_t> ofCorner;     ///< fan per corner, size 3T
  std::vector<std::uint32_t> inputVertex;  ///< input vertex per fan
};
Fans findFans(const CornerTable& table, std::size_t vertexCount);

struct Components {
  std::vector<std::uint32_t> ofTriangle;
  std::vector<std::uint32_t> firstTriangle;  ///< per component
};
Components findComponents(const CornerTable& table);

/// Boundary half-edges, loop by loop in order; the surface is on their left.
std::vector<std::vector<std::uint32_t>> findBoundaryLoops(const CornerTable& table);

}  // namespace abflat
