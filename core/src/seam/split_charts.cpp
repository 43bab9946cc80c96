#include "seam/split_charts.h"

#include "seam/chords.h"
#include "seam/extract_charts.h"

namespace abflat {
namespace {

bool isBad(const Shape& shape, SplitFor reason, const ShapeOptions& options) {
  return shape.overlap > options.mostOverlap || shape.extent > options.longest ||
         (reason == SplitFor::OverlapOrFill && shape.fill < options.leastFill);
}

/// One split for each chart that is asked for; those where none is possible no longer are.
std::uint32_t splitOnce(const SeamMesh& mesh, const CutSurface& s, const PathForest& forest,
                        const std::vector<Shape>& shapes, const ShapeOptions& options,
                        std::vector<SplitFor>& asked, Seams& seams) {
  std::uint32_t splits = 0;
  ChordFinder chords(mesh, s, forest);
  for (std::uint32_t c = 0; c < s.charts.size(); ++c) {
    const SplitFor reason = asked[c];
    asked[c] = SplitFor::Nothing;
    if (reason == SplitFor::Nothing) continue;
    const Chord chord = chords.best(c, shapes[c].crossings);
    // Sides of a slit that just touch are left to the flattening unless one seam parts most of
    // them.
    constexpr double kHalf = 0.5;
    if (chord.h == kNone || (!isBad(shapes[c], reason, options) && chord.resolved < kHalf))
      continue;
    markChord(mesh, s, forest, chord, seams);
    asked[c] = reason;
    ++splits;
  }
  return splits;
}

std::vector<std::uint8_t> areAsked(const std::vector<SplitFor>& asked) {
  std::vector<std::uint8_t> out;
  out.reserve(asked.size());
  for (const SplitFor reason : asked) out.push_back(reason != SplitFor::Nothing);
  return out;
}

/// The pieces of what was split, and the seams within.
struct Pieces {
  SeamPart part;  ///< half-edges and vertices are those of the mesh that the splitting began with
  Seams seams;
};

Pieces takePieces(const SeamMesh& mesh, const CutSurface& s, const std::vector<SplitFor>& asked,
                  const Seams& seams, const Pulse& pulse) {
  Pieces out;
  out.part = extractCharts(mesh, s, areAsked(asked), pulse);
  // What was cut before is the part's boundary.
  for (const std::uint32_t h : out.part.halfEdge)
    out.seams.push_back(seams[h] && s.twin[h] != kNone);
  return out;
}

}  // namespace

std::vector<Shape> shapesToSplit(const SeamMesh& mesh, const CutSurface& s,
                                 const std::vector<double>& u, const ShapeOptions& options,
                                 std::vector<SplitFor>& asked) {
  std::vector<Shape> out(asked.size());
  for (std::uint32_t c = 0; c < s.charts.size(); ++c) {
    if (asked[c] == SplitFor::Nothing) continue;
    if (s.charts[c].triangles > 1 && s.charts[c].loops == 1) {
      out[c] = measureShape(predictOutline(mesh, s, c, u));
      if (isBad(out[c], asked[c], options) || !out[c].crossings.empty()) continue;
    }
    asked[c] = SplitFor::Nothing;
  }
  return out;
}

std::uint32_t splitByShape(const SeamMesh& mesh, const CutSurface& surface,
                           const PathForest& forest, const std::vector<double>& u,
                           const std::vector<Shape>& shapes, const ShapeOptions& options,
                           std::vector<SplitFor>& asked, Seams& seams, const Pulse& pulse) {
  std::uint32_t splits = splitOnce(mesh, surface, forest, shapes, options, asked, seams);
  if (splits == 0) return 0;
  Pieces now = takePieces(mesh, surface, asked, seams, pulse);
  constexpr int kMostLevels = 12;
  for (int level = 1; level < kMostLevels; ++level) {
    const SeamPart& part = now.part;
    std::vector<double> scale;
    scale.reserve(part.vertex.size());
    for (const std::uint32_t v : part.vertex) scale.push_back(u[v]);
    const CutSurface s = cutAlong(part.mesh, now.seams, pulse);
    std::vector<SplitFor> all(s.charts.size(), SplitFor::OverlapOrFill);
    const std::vector<Shape> bad = shapesToSplit(part.mesh, s, scale, options, all);
    const PathForest paths = findPaths(part.mesh, s, {}, areAsked(all), pulse);
    const std::uint32_t more = splitOnce(part.mesh, s, paths, bad, options, all, now.seams);
    if (more == 0) break;
    splits += more;
    for (std::size_t h = 0; h < now.seams.size(); ++h)
      if (now.seams[h]) seams[part.halfEdge[h]] = 1;
    Pieces next = takePieces(part.mesh, s, all, now.seams, pulse);
    for (std::uint32_t& h : next.part.halfEdge) h = part.halfEdge[h];
    for (std::uint32_t& v : next.part.vertex) v = part.vertex[v];
    now = std::move(next);
  }
  return splits;
}

}  // namespace abflat
