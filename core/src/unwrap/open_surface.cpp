#include "unwrap/open_surface.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "cut/filled_table.h"

namespace abflat {

IdVector<InputVertex, std::uint32_t> ranksOfMesh(const OpenSurface& open, std::size_t vertices) {
  IdVector<InputVertex, std::uint32_t> out(vertices, std::numeric_limits<std::uint32_t>::max());
  for (const SurfaceVertex v : open.eliminationRanks.ids()) {
    // The surface may meet itself in a vertex; then the numbers of its fans must not matter.
    std::uint32_t& rank = out[open.inputVertex[v]];
    rank = std::min(rank, open.eliminationRanks[v]);
  }
  return out;
}

ChartSet chartsOf(const WeldedMesh& welded, const OpenSurface& open) {
  ChartSet out = makeCharts(welded.mesh, filledTable(open.mesh, open.inputVertex, open.seams));
  // Charts are factored in the order found for the whole surface.
  out.eliminationRank = ranksOfMesh(open, welded.mesh.vertexCount());
  return out;
}

}  // namespace abflat
