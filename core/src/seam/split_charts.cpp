#include "seam/split_charts.h"

#include "seam/chords.h"
#include "seam/extract_charts.h"
#include "seam/outline.h"

namespace abflat {
namespace {

/// One split for each chart that is asked for and needs one; the others are no longer asked for.
std::uint32_t splitOnce(const SeamMesh& mesh, const CutSurface& s, const PathForest& forest,
                        const std::vector<double>& u, const ShapeOptions& options,
                        std::vector<std::uint8_t>& asked, Seams& seams) {
  std::uint32_t splits = 0;
  ChordFinder chords(mesh, s, forest);
  for (std::uint32_t c = 0; c < s.charts.size(); ++c) {
    if (!asked[c]) continue;
    asked[c] = 0;
    if (s.charts[c].triangles < 2 || s.charts[c].loops != 1) continue;
    const Shape shape = measureShape(predictOutline(mesh, s, s.charts[c].loopBegin, u));
    if (shape.fill >= options.leastFill && shape.overlap <= options.mostOverlap) continue;
    const Chord chord = chords.best(c, shape.crossings);
    if (chord.h == kNone) continue;
    markEdge(mesh, chord.h, seams);
    markPath(mesh, forest, s.vertexOfCorner[chord.h], seams);
    markPath(mesh, forest, s.vertexOfCorner[nextCorner(chord.h)], seams);
    asked[c] = 1;
    ++splits;
  }
  return splits;
}

/// The charts that were just split, along the new seams, as a part of their own.
SeamPart splitPart(const SeamMesh& mesh, const CutSurface& s,
                   const std::vector<std::uint8_t>& isSplit, const Seams& seams, Seams& own) {
  SeamPart part = extractCharts(mesh, s, isSplit);
  own.clear();
  for (const std::uint32_t h : part.halfEdge) own.push_back(seams[h] && s.twin[h] != kNone);
  return part;
}

}  // namespace

std::uint32_t splitByShape(const SeamMesh& mesh, const CutSurface& surface,
                           const PathForest& forest, const std::vector<double>& u,
                           const ShapeOptions& options, std::vector<std::uint8_t>& asked,
                           Seams& seams) {
  constexpr int kMostLevels = 12;
  std::uint32_t splits = splitOnce(mesh, surface, forest, u, options, asked, seams);
  std::uint32_t last = splits;
  Seams own;
  SeamPart part;
  if (last > 0) part = splitPart(mesh, surface, asked, seams, own);
  std::vector<std::uint32_t> vertex = part.vertex, halfEdge = part.halfEdge;
  for (int level = 0; last > 0 && level < kMostLevels; ++level) {
    const CutSurface s = cutAlong(part.mesh, own);
    std::vector<double> scale;
    for (const std::uint32_t v : vertex) scale.push_back(u[v]);
    std::vector<std::uint8_t> inner(s.charts.size(), 1);
    last = splitOnce(part.mesh, s, findPaths(part.mesh, s, {}), scale, options, inner, own);
    splits += last;
    for (std::size_t h = 0; h < own.size(); ++h)
      if (own[h]) seams[halfEdge[h]] = 1;
    if (last == 0) break;
    Seams next;
    part = splitPart(part.mesh, s, inner, own, next);
    own = std::move(next);
    for (std::uint32_t& v : part.vertex) v = vertex[v];
    for (std::uint32_t& h : part.halfEdge) h = halfEdge[h];
    vertex = part.vertex;
    halfEdge = part.halfEdge;
  }
  return splits;
}

}  // namespace abflat
