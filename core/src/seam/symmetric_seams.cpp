#include "seam/symmetric_seams.h"

#include <algorithm>

#include "mesh/corner_table.h"

namespace abflat {
namespace {

/// Decided by most of its corners; for a triangle across the plane either side will do.
bool isOnFirstSide(const SeamMesh& mesh, const Mirror& mirror, SurfaceTriangle triangle) {
  int sum = 0;
  for (const SurfaceCorner c : cornersOf(triangle)) sum += mirror.side[mesh.vertexOfCorner[c]];
  return sum > 0;
}

/// Whether the edge separates the two sides of the plane.
bool isBetween(const SeamMesh& mesh, const Mirror& mirror, SurfaceCorner h) {
  return mesh.twin[h].exists() && isOnFirstSide(mesh, mirror, triangleOf(h)) !=
                                      isOnFirstSide(mesh, mirror, triangleOf(mesh.twin[h]));
}

bool areDisks(const CutSurface& s) {
  return std::all_of(s.charts.begin(), s.charts.end(),
                     [](const CutSurface::Chart& chart) { return chart.isDisk(); });
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

Seams mirrored(const SeamMesh& mesh, const Mirror& mirror, const Seams& seams, int from) {
  Seams out = seams;
  for (const SurfaceCorner h : seams.ids())
    if (mirror.sideOf(mesh, h) == -from && mirror.hasImage(h)) out[h] = 0;
  for (const SurfaceCorner h : seams.ids())
    if (seams[h] && mirror.sideOf(mesh, h) != -from)
      mirror.forEachImage(h, [&](SurfaceCorner i) { out[i] = out[mesh.twin[i]] = 1; });
  return out;
}

void cutAlongPlane(const SeamMesh& mesh, const Mirror& mirror, double broadest, Seams& seams) {
  const CutSurface s = cutAlong(mesh, seams);
  IdVector<CutChartId, double> length(s.charts.size(), 0);
  IdVector<CutChartId, std::uint8_t> isBarred(s.charts.size(), 0);
  const auto isNew = [&](SurfaceCorner h) { return !seams[h] && isBetween(mesh, mirror, h); };
  for (const SurfaceCorner h : mesh.corners()) {
    if (!isNew(h)) continue;
    length[s.chartOf(h)] += mesh.length[h] / 2;
    if (!(mesh.cost[h] < kBarredCost)) isBarred[s.chartOf(h)] = 1;
  }
  for (const SurfaceCorner h : mesh.corners()) {
    const CutChartId c = s.chartOf(h);
    const bool isNarrow = s.charts[c].area < broadest * length[c] * length[c];
    if (isNarrow && !isBarred[c] && isBetween(mesh, mirror, h)) seams[h] = 1;
  }
}

std::vector<SurfaceCorner> addImages(const SeamMesh& mesh, const Mirror& mirror,
                                     const Seams& before, Seams& seams, const Listener& listener) {
  std::vector<SurfaceCorner> added;
  Seams both = seams;
  for (const SurfaceCorner h : seams.ids()) {
    if (!seams[h] || before[h]) continue;
    mirror.forEachImage(h, [&](SurfaceCorner i) {
      for (const SurfaceCorner g : {i, mesh.twin[i]}) {
        if (!both[g]) added.push_back(g);
        both[g] = 1;
      }
    });
  }
  if (added.empty() || !areDisks(cutAlong(mesh, both, listener))) return {};
  seams = std::move(both);
  return added;
}

}  // namespace abflat
