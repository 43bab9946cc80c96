#pragma once

#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "base/listener.h"
#include "islands/find_islands.h"
#include "islands/mapped_triangles.h"
#include "islands/stack_shapes.h"

namespace abflat {

/// Stands for the stack of a face without an island.
constexpr std::uint32_t kNoStack = 0xffffffffu;

/// The layout of a mesh: its islands, and the stacks that they move in.
struct MeshLayout {
  std::vector<std::uint32_t> islandOfFace;     ///< or kNoIsland
  std::vector<std::uint32_t> triangleCorners;  ///< 3 per triangle of the mesh, mapped or not
  MappedTriangles triangles;
  std::vector<IslandStack> stacks;
  std::vector<std::uint32_t> stackOfIsland;
  std::size_t separated = 0;  ///< islands that overlap others without moving together with them
  int exponent = 0;           ///< areas in 3D are in units of 4^exponent

  std::uint32_t stackOf(std::uint32_t face) const;
};

/// `byMaterial`: islands of different materials are no stack. Incomplete once `listener` has
/// stopped.
MeshLayout readLayout(const PolygonMesh& mesh, Islands islands, bool byMaterial,
                      const Listener& listener);

}  // namespace abflat
