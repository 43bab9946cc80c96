#include "seam/split_charts.h"

#include "seam/chords.h"
#include "seam/extract_charts.h"

namespace abflat {
namespace {

bool isBad(const Shape& shape, SplitFor reason, const ShapeOptions& options) {
  return shape.overlap > options.mostOverlap || shape.extent > options.longest ||
         (reason == SplitFor::OverlapOrFill && shape.fill < options.leastFill);
}

/// Per chart, whether all of it lies in one plane: a seam would be in plain sight.
IdVector<CutChartId, std::uint8_t> areFlat(const SeamMesh& mesh, const CutSurface& s) {
  IdVector<CutChartId, std::uint8_t> out(s.charts.size(), 1);
  for (const SurfaceCorner h : mesh.corners())
    if (s.twin[h].exists() && mesh.plainCost(h) <= mesh.length[h]) out[s.chartOf(h)] = 0;
  return out;
}

/// Makes one split in each chart that asks for it. Charts that cannot be split no longer ask.
std::uint32_t splitOnce(const CutPaths& paths, const ShapeOptions& options, SplitCharts& charts,
                        Seams& seams) {
  std::uint32_t splits = 0;
  ChordFinder chords(paths);
  for (const CutChartId c : charts.asked.ids()) {
    const SplitFor reason = charts.asked[c];
    const Shape& shape = charts.shape[c];
    charts.asked[c] = SplitFor::Nothing;
    if (reason == SplitFor::Nothing) continue;
    const Chord chord = chords.best(c, shape.crossings);
    // Slit sides that just touch are left to flattening, unless a single seam separates most of
    // them.
    constexpr double kHalf = 0.5;
    if (!chord.h.exists() || (!isBad(shape, reason, options) && chord.resolved < kHalf)) continue;
    markThrough(paths, chord.h, seams);
    charts.asked[c] = reason;
    ++splits;
  }
  return splits;
}

IdVector<CutChartId, std::uint8_t> areAsked(const IdVector<CutChartId, SplitFor>& asked) {
  IdVector<CutChartId, std::uint8_t> out;
  out.reserve(asked.size());
  for (const SplitFor reason : asked) out.push_back(reason != SplitFor::Nothing);
  return out;
}

/// The pieces of the charts that were split, and the seams within them.
struct Pieces {
  SeamPart part;  ///< of the mesh that splitting began with
  Seams seams;
};

Pieces takePieces(const SeamMesh& mesh, const CutSurface& s,
                  const IdVector<CutChartId, SplitFor>& asked, const Seams& seams,
                  const Listener& listener) {
  Pieces out;
  out.part = extractCharts(mesh, s, areAsked(asked), listener);
  // What was cut before is on the part's boundary.
  for (const SurfaceCorner h : out.part.wholeHalfEdge)
    out.seams.push_back(seams[h] && s.twin[h].exists());
  return out;
}

}  // namespace

SplitCharts chartsToSplit(const SeamMesh& mesh, const CutSurface& s, const LogScales& u,
                          const ShapeOptions& options, IdVector<CutChartId, SplitFor> asked) {
  SplitCharts out{std::move(asked), {}};
  out.shape.resize(out.asked.size());
  const IdVector<CutChartId, std::uint8_t> isFlat = areFlat(mesh, s);
  for (const CutChartId c : s.charts.ids()) {
    if (out.asked[c] == SplitFor::Nothing) continue;
    Shape& shape = out.shape[c];
    if (s.charts[c].triangles > 1 && s.charts[c].loops == 1) {
      shape = measureShape(predictOutline(mesh, s, c, u));
      // Packing fills the hole of a ring.
      if (isFlat[c]) shape.fill = 1;
      if (isBad(shape, out.asked[c], options) || !shape.crossings.empty()) continue;
    }
    out.asked[c] = SplitFor::Nothing;
  }
  return out;
}

std::uint32_t splitByShape(const CutPaths& paths, const LogScales& u, const ShapeOptions& options,
                           SplitCharts& charts, Seams& seams, const Listener& listener) {
  std::uint32_t splits = splitOnce(paths, options, charts, seams);
  if (splits == 0) return 0;
  Pieces now = takePieces(paths.mesh, paths.surface, charts.asked, seams, listener);
  constexpr int kMostLevels = 12;
  for (int level = 1; level < kMostLevels; ++level) {
    const SeamPart& part = now.part;
    const CutSurface s = cutAlong(part.mesh, now.seams, listener);
    SplitCharts bad =
        chartsToSplit(part.mesh, s, part.ofVertices(u), options,
                      IdVector<CutChartId, SplitFor>(s.charts.size(), SplitFor::OverlapOrFill));
    const PathForest forest = findPaths(part.mesh, s, {}, areAsked(bad.asked), listener);
    const std::uint32_t more = splitOnce({part.mesh, s, forest}, options, bad, now.seams);
    if (more == 0) break;
    splits += more;
    for (const SurfaceCorner h : now.seams.ids())
      if (now.seams[h]) seams[part.wholeHalfEdge[h]] = 1;
    Pieces next = takePieces(part.mesh, s, bad.asked, now.seams, listener);
    next.part.embedIn(part);
    now = std::move(next);
  }
  return splits;
}

}  // namespace abflat
