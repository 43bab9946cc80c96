#pragma once

#include <memory>

#include "seam/extract_charts.h"
#include "seam/log_scale.h"

namespace abflat {

/// What is still being cut: a whole mesh, or some of its charts as a mesh of their own.
struct PartInWork {
  const SeamMesh* whole = nullptr;
  std::unique_ptr<const SeamPart> part;  ///< null: the whole
  Seams seams;                           ///< of mesh()
  std::unique_ptr<LogScale> solver;      ///< of mesh()

  const SeamMesh& mesh() const { return part ? part->mesh : *whole; }
  SurfaceCorner toWhole(SurfaceCorner h) const { return part ? part->wholeHalfEdge[h] : h; }
  SurfaceVertex toWhole(SurfaceVertex v) const { return part ? part->wholeVertex[v] : v; }

  /// Marks the seams of this part among those of the whole.
  void addTo(Seams& ofWhole) const {
    for (const SurfaceCorner h : seams.ids())
      if (seams[h]) ofWhole[toWhole(h)] = 1;
  }
};

/// The wanted charts as a part of their own. `surface`: the mesh as it was cut before the last of
/// its seams. `ranks` are of the whole.
PartInWork extractPart(const PartInWork& from, const CutSurface& surface,
                       const IdVector<CutChartId, std::uint8_t>& isWanted,
                       const EliminationRanks& ranks, ThreadPool* pool, const Listener& listener);

}  // namespace abflat
