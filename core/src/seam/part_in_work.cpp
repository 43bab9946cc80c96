#include "seam/part_in_work.h"

#include <utility>

namespace abflat {

PartInWork extractPart(const PartInWork& from, const CutSurface& surface,
                       const IdVector<CutChartId, std::uint8_t>& isWanted,
                       const EliminationRanks& ranks, ThreadPool* pool, const Listener& listener) {
  auto part = std::make_unique<SeamPart>(extractCharts(from.mesh(), surface, isWanted, listener));
  PartInWork out;
  out.whole = from.whole;
  // What was cut before is on the part's boundary.
  for (const SurfaceCorner h : part->wholeHalfEdge)
    out.seams.push_back(from.seams[h] && surface.twin[h].exists());
  if (from.part) part->embedIn(*from.part);
  out.solver = std::make_unique<LogScale>(part->mesh, pool, part->ofVertices(ranks));
  out.part = std::move(part);
  return out;
}

}  // namespace abflat
