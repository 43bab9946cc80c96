#include "seam/part_charts.h"

#include "seam/chords.h"

namespace abflat {
namespace {

/// Per chart, the pairs that are still in it, as places of its outline.
using Together = IdVector<CutChartId, std::vector<std::array<BoundaryIndex, 2>>>;

Together togetherOn(const CutSurface& surface, const std::vector<OutlinePair>& pairs) {
  Together out(surface.charts.size());
  IdVector<SurfaceCorner, BoundaryIndex> alongLoop(surface.twin.size());
  for (const CutChartId c : surface.charts.ids()) {
    if (!surface.charts[c].isDisk()) continue;
    const BoundaryLoop loop = surface.outline(c);
    for (const BoundaryIndex i : loop.ids()) alongLoop[loop[i]] = i;
  }
  for (const auto& [a, b] : pairs) {
    const CutChartId c = surface.chartOf(a);
    if (c == surface.chartOf(b) && surface.charts[c].isDisk())
      out[c].push_back({alongLoop[a], alongLoop[b]});
  }
  return out;
}

/// Splits each of these charts once.
bool partOnce(const SeamMesh& mesh, const std::vector<OutlinePair>& pairs, Seams& seams) {
  const CutSurface surface = cutAlong(mesh, seams);
  const Together together = togetherOn(surface, pairs);
  IdVector<CutChartId, std::uint8_t> isWanted;
  for (const auto& places : together) isWanted.push_back(!places.empty());
  const PathForest forest = findPaths(mesh, surface, {}, isWanted);
  const CutPaths paths{mesh, surface, forest};
  ChordFinder chords(paths);
  bool isAny = false;
  for (const CutChartId c : surface.charts.ids()) {
    if (!isWanted[c]) continue;
    const Chord chord = chords.apart(c, together[c]);
    if (!chord.h.exists()) continue;
    markThrough(paths, chord.h, seams);
    isAny = true;
  }
  return isAny;
}

}  // namespace

bool partCharts(const SeamMesh& mesh, const std::vector<OutlinePair>& pairs, Seams& seams) {
  constexpr int kMostLevels = 12;
  int level = 0;
  while (level < kMostLevels && partOnce(mesh, pairs, seams)) ++level;
  return level > 0;
}

}  // namespace abflat
