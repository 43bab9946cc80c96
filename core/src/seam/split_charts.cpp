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
    if (!isBad && shape.crossings.empty()) continue;
    const Chord chord = chords.best(c, shape.crossings);
    // Sides of a slit that just touch are left to the flattening unless one seam parts most of
    // them.
    constexpr double kHalf = 0.5;
    if (chord.h == kNone || (!isBad && chord.resolved < kHalf)) continue;
    markChord(mesh, s, forest, chord, seams);
    asked[c] = reason;
    ++splits;
  }
  return splits;
}

/// The pieces of what was split, and the seams within.
struct Pieces {
  SeamPart part;  ///< half-edges and vertices are those of the mesh that the splitting began with
  Seams seams;
};

Pieces takePieces(const SeamMesh& mesh, const CutSurface& s, const std::vector<SplitFor>& asked,
                  const Seams& seams) {
  std::vector<std::uint8_t> isSplit;
  isSplit.reserve(asked.size());
  for (const SplitFor reason : asked) isSplit.push_back(reason != SplitFor::Nothing);
  Pieces out;
  out.part = extractCharts(mesh, s, isSplit);
  // What was cut before is the part's boundary.
  for (const std::uint32_t h : out.part.halfEdge)
    out.seams.push_back(seams[h] && s.twin[h] != kNone);
  return out;
}

}  // namespace

std::uint32_t splitByShape(const SeamMesh& mesh, const CutSurface& surface,
                           const PathForest& forest, const std::vector<double>& u,
                           const ShapeOptions& options, std::vector<SplitFor>& asked,
                           Seams& seams) {
  std::uint32_t splits = splitOnce(mesh, surface, forest, u, options, asked, seams);
  if (splits == 0) return 0;
  Pieces now = takePieces(mesh, surface, asked, seams);
  constexpr int kMostLevels = 12;
  for (int level = 1; level < kMostLevels; ++level) {
    const SeamPart& part = now.part;
    std::vector<double> scale;
    scale.reserve(part.vertex.size());
    for (const std::uint32_t v : part.vertex) scale.push_back(u[v]);
    const CutSurface s = cutAlong(part.mesh, now.seams);
    std::vector<SplitFor> all(s.charts.size(), SplitFor::OverlapOrFill);
    const std::uint32_t more =
        splitOnce(part.mesh, s, findPaths(part.mesh, s, {}), scale, options, all, now.seams);
    if (more == 0) break;
    splits += more;
    for (std::size_t h = 0; h < now.seams.size(); ++h)
      if (now.seams[h]) seams[part.halfEdge[h]] = 1;
    Pieces next = takePieces(part.mesh, s, all, now.seams);
    for (std::uint32_t& h : next.part.halfEdge) h = part.halfEdge[h];
    for (std::uint32_t& v : next.part.vertex) v = part.vertex[v];
    now = std::move(next);
  }
  return splits;
}

}  // namespace abflat
