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

namespace {

/// The mean of each chart's triangles. A mask without a seam may be stretched even more.
IdVector<ChartId, double> leewayOfCharts(const OpenSurface& open, const ChartSet& set) {
  constexpr double kOfMask = 1.5;
  const SeamMesh& mesh = open.mesh;
  IdVector<ChartId, double> out;
  for (const ChartId i : set.ids()) {
    double area = 0, sum = 0;
    bool isUncut = true;
    for (const SurfaceTriangle f : set.topology(i).triangles) {
      area += mesh.area[f];
      sum += mesh.area[f] * (mesh.leewayAt(f) - 1);
      for (const SurfaceCorner h : cornersOf(f)) isUncut = isUncut && !open.seams[h];
    }
    out.push_back(1 + (area > 0 ? (isUncut ? kOfMask : 1) * sum / area : 0));
  }
  return out;
}

}  // namespace

ChartSet chartsOf(const WeldedMesh& welded, const OpenSurface& open) {
  ChartSet out = makeCharts(welded.mesh, filledTable(open.mesh, open.inputVertex, open.seams));
  // Charts are factored in the order found for the whole surface.
  out.eliminationRank = ranksOfMesh(open, welded.mesh.vertexCount());
  if (!open.mesh.front.empty()) out.leeway = leewayOfCharts(open, out);
  return out;
}

}  // namespace abflat
