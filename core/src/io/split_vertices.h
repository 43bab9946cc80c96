#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace abflat {

/// Vertices for a format with one texcoord per vertex: those of the mesh in their order, followed
/// by a copy for every further texcoord of a vertex.
struct SplitVertices {
  std::vector<std::uint32_t> ofCorner;  ///< vertex of each face corner
  std::vector<std::uint32_t> copied;    ///< vertex of the mesh that each copy repeats
  std::vector<double> uv;               ///< 2 per vertex; 0 where no corner has any
};

/// Arguments as for writePly; `uv` may be empty.
SplitVertices splitVertices(std::size_t vertexCount, const std::vector<std::uint32_t>& faceVertices,
                            const std::vector<double>& uv,
                            const std::vector<std::uint32_t>& cornerUv);

}  // namespace abflat
