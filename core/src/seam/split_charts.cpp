#include "seam/split_charts.h"

#include "seam/chords.h"
#include "seam/extract_charts.h"
#include "seam/outline.h"

namespace abflat {
namespace {

/// One split for each chart that is asked for and needs one; the others are no longer asked for.
std::uint32_t splitOnce(const SeamMesh& mesh, const CutSurface& s, const PathForest& forest,
                        const std::vector<double>& u, const ShapeOptions& options,
                        std::vector<SplitFor>& asked, Seams& seams) {
  std::uint32_t splits = 0;
  ChordFinder chords(mesh, s, forest);
  for (std::uint32_t c = 0; c < s.charts.size(); ++c) {
    const SplitFor reason = asked[c];
    asked[c] = SplitFor::Nothing;
    if (reason == SplitFor::Nothing) continue;
    if (s.charts[c].triangles < 2 || s.charts[c].loops != 1) continue;
    const Shape shape = measureShape(predictOutline(mesh, s, s.charts[c].loopBegin, u));
    const bool isBad = shape.overlap > options.mostOverlap ||
                       (reason == SplitFor::OverlapOrFill && shape.fill < options.leastFill);
    if (!isBad) continue;
    const Chord chord = chords.best(c, shape.crossings);
    if (chord.h == kNone) continue;
    markEdge(mesh, chord.h, seams);
    markPath(mesh, forest, s.vertexOfCorner[chord.h], seams);
    markPath(mesh, forest, s.vertexOfCorner[nextCorner(chord.h)], seams);
    asked[c] = reason;
    ++splits;
  }
  return splits;
}

/// Goes on, level by level, with the pieces of what was split alone.
std::uint32_t splitLevels(const SeamMesh& mesh, const CutSurface& s, const PathForest& forest,
                          const std::vector<double>& u, const ShapeOptions& options,
                          std::vector<SplitFor>& asked, Seams& seams, int levels) {
  std::uint32_t splits = splitOnce(mesh, s, forest, u, options, asked, seams);
  if (splits == 0 || levels == 1) return splits;
  std::vector<std::uint8_t> isSplit;
  for (const SplitFor reason : asked) isSplit.push_back(reason != SplitFor::Nothing);
  const SeamPart part = extractCharts(mesh, s, isSplit);
  Seams own;  // what was cut before is the part's boundary
  for (const std::uint32_t h : part.halfEdge) own.push_back(seams[h] && s.twin[h] != kNone);
  std::vector<double> scale;
  for (const std::uint32_t v : part.vertex) scale.push_back(u[v]);
  const CutSurface pieces = cutAlong(part.mesh, own);
  std::vector<SplitFor> all(pieces.charts.size(), SplitFor::OverlapOrFill);
  splits += splitLevels(part.mesh, pieces, findPaths(part.mesh, pieces, {}), scale, options, all,
                        own, levels - 1);
  for (std::size_t h = 0; h < own.size(); ++h)
    if (own[h]) seams[part.halfEdge[h]] = 1;
  return splits;
}

}  // namespace

std::uint32_t splitByShape(const SeamMesh& mesh, const CutSurface& surface,
                           const PathForest& forest, const std::vector<double>& u,
                           const ShapeOptions& options, std::vector<SplitFor>& asked,
                           Seams& seams) {
  constexpr int kMostLevels = 12;
  return splitLevels(mesh, surface, forest, u, options, asked, seams, kMostLevels);
}

}  // namespace abflat
