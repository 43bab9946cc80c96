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
    if (!seams[h]) continue;
    all += mesh.length[h];
    const SurfaceCorner image = mirror.image[h];
    if (image.exists() && seams[image]) mirrored += mesh.length[h];
  }
  return all > 0 ? mirrored / all : 1;
}

std::optional<SeamPart> halfOf(const SeamMesh& mesh, const Mirror& mirror, FillHoles mode) {
  Seams between(mesh.twin.size(), 0);
  for (const SurfaceCorner h : mesh.corners()) {
    between[h] = isBetween(mesh, mirror, h);
    if (between[h] && !(mesh.cost[h] < kBarredCost)) return {};
  }
  CutSurface s = cutAlong(mesh, between);
  if (openTouchedHoles(mesh, s, mode, between)) s = cutAlong(mesh, between);
  IdVector<CutChartId, std::uint8_t> isWanted;
  for (const CutSurface::Chart& chart : s.charts)
    isWanted.push_back(isOnFirstSide(mesh, mirror, chart.firstTriangle) &&
                       !mesh.isFilling(chart.firstTriangle));
  return extractCharts(mesh, s, isWanted);
}

Seams unfold(const SeamMesh& mesh, const Mirror& mirror, const SeamPart& half, const Seams& seams) {
  Seams out(mesh.twin.size(), 0);
  const auto mark = [&](SurfaceCorner h) {
    if (!h.exists() || !mesh.twin[h].exists() || !(mesh.cost[h] < kBarredCost)) return;
    out[h] = out[mesh.twin[h]] = 1;
  };
  for (const SurfaceCorner h : out.ids())
    if (isBetween(mesh, mirror, h)) mark(h);
  for (const SurfaceCorner h : seams.ids()) {
    if (!seams[h]) continue;
    mark(half.wholeHalfEdge[h]);
    mark(mirror.image[half.wholeHalfEdge[h]]);
  }
  return out;
}

}  // namespace abflat
