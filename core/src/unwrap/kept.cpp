#include "unwrap/kept.h"

#include <utility>

#include "seam/extract_charts.h"

namespace abflat {

KeptTriangles::KeptTriangles(const IdVector<SurfaceTriangle, std::uint8_t>& isKept) {
  number_.resize(isKept.size());
  for (const SurfaceTriangle f : isKept.ids())
    if (isKept[f]) number_[f] = kept_.push_back(f);
}

Surface KeptTriangles::surface(const Surface& whole, std::size_t vertices) const {
  Surface out;
  out.summary = whole.summary;
  const Triangulation& from = whole.triangulation;
  out.triangulation = {ofCorners(from.vertex), ofCorners(from.corner), ofTriangles(from.face),
                       ofCorners(from.isDiagonal)};
  out.table.vertex = out.triangulation.vertex;
  for (const SurfaceCorner o : ofCorners(whole.table.twin)) {
    const SurfaceTriangle f = o.exists() ? number_[triangleOf(o)] : SurfaceTriangle();
    out.table.twin.push_back(f.exists() ? cornerOf(f, placeInTriangle(o)) : SurfaceCorner());
  }
  out.fans = findFans(out.table, vertices);
  return out;
}

FixedTriangles KeptTriangles::fixed(FixedTriangles whole) const {
  whole.isFixed = ofTriangles(whole.isFixed);
  whole.borders = ofCorners(whole.borders);
  return whole;
}

OpenSurface keptCharts(const OpenSurface& whole,
                       const IdVector<SurfaceTriangle, std::uint8_t>& isKept) {
  const CutSurface s = cutAlong(whole.mesh, whole.seams);
  IdVector<CutChartId, std::uint8_t> isWanted;
  for (const CutSurface::Chart& chart : s.charts)
    isWanted.push_back(chart.firstTriangle < isKept.size() && isKept[chart.firstTriangle]);
  SeamPart part = extractCharts(whole.mesh, s, isWanted);
  OpenSurface out;
  out.unit = whole.unit;
  for (const SurfaceVertex v : part.wholeVertex) out.inputVertex.push_back(whole.inputVertex[v]);
  for (const SurfaceCorner h : part.wholeHalfEdge)
    if (h < whole.given.size()) out.given.push_back(whole.given[h]);
  out.seams.assign(part.wholeHalfEdge.size(), 0);
  out.found = out.seams;
  out.eliminationRanks = part.ofVertices(whole.eliminationRanks);
  out.scale = part.ofVertices(whole.scale);
  out.foundScale = part.ofVertices(whole.foundScale);
  out.mirror = whole.mirror.ofPart(part);
  out.mesh = std::move(part.mesh);
  return out;
}

}  // namespace abflat
