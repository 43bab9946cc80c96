#include "seam/symmetric_seams.h"

#include "hole/fill_holes.h"
#include "mesh/corner_table.h"

namespace abflat {
namespace {

/// Decided by most of its corners; for a triangle across the plane either side will do.
bool isOnFirstSide(const SeamMesh& mesh, const Mirror& mirror, SurfaceTriangle triangle) {
  int sum = 0;
  for (const SurfaceCorner c : cornersOf(triangle)) sum += mirror.side[mesh.vertexOfCorner[c]];
  return sum > 0;
}

bool isBetween(const SeamMesh& mesh, const Mirror& mirror, SurfaceCorner h) {
  return mesh.twin[h].exists() && isOnFirstSide(mesh, mirror, triangleOf(h)) !=
                                      isOnFirstSide(mesh, mirror, triangleOf(mesh.twin[h]));
}

}  // namespace

double mirroredShare(const SeamMesh& mesh, const Mirror& mirror, const Seams& seams) {
  double all = 0, mirrored = 0;
  for (const SurfaceCorner h : seams.ids()) {
    if (!seams[h] || !mirror.hasImage(h)) continue;
    all += mesh.length[h];
    bool isMirrored = true;
    mirror.forEachImage(h, [&](SurfaceCorner i) { isMirrored = isMirrored && seams[i]; });
    if (isMirrored) mirrored += mesh.length[h];
  }
  return all > 0 ? mirrored / all : 1;
}

std::optional<Seams> planeSeams(const SeamMesh& mesh, const Mirror& mirror) {
  Seams out;
  for (const SurfaceCorner h : mesh.corners()) {
    out.push_back(isBetween(mesh, mirror, h));
    if (out.back() && !(mesh.cost[h] < kBarredCost)) return {};
  }
  return out;
}

std::optional<SeamPart> halfOf(const SeamMesh& mesh, const Mirror& mirror, FillHoles mode) {
  std::optional<Seams> between = planeSeams(mesh, mirror);
  if (!between) return {};
  CutSurface s = cutAlong(mesh, *between);
  if (openTouchedHoles(mesh, s, mode, *between)) s = cutAlong(mesh, *between);
  IdVector<CutChartId, std::uint8_t> isWanted;
  for (const CutSurface::Chart& chart : s.charts)
    isWanted.push_back(isOnFirstSide(mesh, mirror, chart.firstTriangle) &&
                       !mesh.isFilling(chart.firstTriangle));
  return extractCharts(mesh, s, isWanted);
}

Seams unfold(const SeamMesh& mesh, const Mirror& mirror, const SeamPart& half, const Seams& seams) {
  Seams out(mesh.twin.size(), 0);
  for (const SurfaceCorner i : seams.ids()) {
    const SurfaceCorner h = half.wholeHalfEdge[i];
    if (seams[i] && mesh.twin[h].exists()) out[h] = out[mesh.twin[h]] = 1;
  }
  for (const SurfaceCorner h : mesh.corners())
    if (isBetween(mesh, mirror, h)) out[h] = 1;
  return mirrored(mesh, mirror, out, 1);
}

Seams mirrored(const SeamMesh& mesh, const Mirror& mirror, const Seams& seams, int from) {
  Seams out = seams;
  for (const SurfaceCorner h : seams.ids())
    if (mirror.sideOf(mesh, h) == -from && mirror.hasImage(h)) out[h] = 0;
  for (const SurfaceCorner h : seams.ids())
    if (seams[h] && mirror.sideOf(mesh, h) != -from)
      mirror.forEachImage(h, [&](SurfaceCorner i) { out[i] = out[mesh.twin[i]] = 1; });
  return out;
}

}  // namespace abflat
