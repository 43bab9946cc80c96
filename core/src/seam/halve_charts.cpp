#include "seam/halve_charts.h"

#include "seam/chords.h"

namespace abflat {

IdVector<CutChartId, std::uint8_t> halveCharts(const SeamMesh& mesh, const CutSurface& surface,
                                               const IdVector<CutChartId, std::uint8_t>& isWanted,
                                               Seams& seams) {
  IdVector<CutChartId, std::uint8_t> out(surface.charts.size(), 0);
  const PathForest forest = findPaths(mesh, surface, {}, isWanted);
  const CutPaths paths{mesh, surface, forest};
  ChordFinder chords(paths);
  for (const CutChartId c : surface.charts.ids()) {
    if (!isWanted[c] || !surface.charts[c].isDisk()) continue;
    const Chord chord = chords.forHalving(c);
    if (!chord.h.exists()) continue;
    markThrough(paths, chord.h, seams);
    out[c] = 1;
  }
  return out;
}

}  // namespace abflat
