#pragma once

#include <cstdint>
#include <vector>

#include "abflat/mesh.h"

namespace abflat {

/// The uv islands of a mesh: its faces, joined where they have an edge in common with the same
/// texcoords on both sides.
struct Islands {
  std::vector<std::uint32_t> ofFace;  ///< or kNoIsland: a corner has no finite texcoord
  std::uint32_t count = 0;
};

/// Islands are numbered by their first faces. Positions and texcoords count by what they are, not
/// by their indices, since many files repeat them.
Islands findIslands(const PolygonMesh& mesh);

}  // namespace abflat
