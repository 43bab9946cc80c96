#include "seam/crease_seams.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"

namespace abflat {

Seams creasesToBegin(const SeamMesh& mesh) {
  constexpr double kCheap = 0.6;      // cost, relative to the length
  constexpr double kNotable = 0.25;   // length, relative to the root of the component's area
  constexpr std::size_t kFew = 64, kShare = 3;
  const CutSurface whole = cutAlong(mesh, Seams(mesh.twin.size(), 0));
  Seams out(mesh.twin.size(), 0);
  IdVector<CutChartId, double> length(whole.charts.size(), 0);
  for (const SurfaceCorner h : mesh.corners())
    if (mesh.isOnSurface(h) && mesh.cost[h] < kCheap * mesh.length[h]) {
      out[h] = 1;
      length[whole.chartOf(h)] += mesh.length[h] / 2;
    }
  IdVector<SurfaceVertex, std::uint8_t> isOnCrease(mesh.vertexCount(), 0);
  IdVector<CutChartId, double> inside(whole.charts.size(), 0), all(whole.charts.size(), 0);
  for (const SurfaceCorner h : mesh.corners())
    if (out[h]) isOnCrease[mesh.tail(h)] = 1;
  for (const OpenVertex v : whole.vertices()) {
    const SurfaceVertex i = whole.meshVertex[v];
    const double curvature = whole.isBoundary[v] ? 0 : std::abs(2 * kPi - mesh.angleSum[i]);
    all[whole.chartOf(v)] += curvature;
    if (!isOnCrease[i]) inside[whole.chartOf(v)] += curvature;
  }
  static double kSh = getenv("X_S") ? atof(getenv("X_S")) : 0.3;
  const CutSurface apart = cutAlong(mesh, out);
  IdVector<CutChartId, std::size_t> patches(whole.charts.size(), 0);
  for (const CutSurface::Chart& patch : apart.charts)
    ++patches[whole.chartOfTriangle[patch.firstTriangle]];
  bool isAny = false;
  for (const SurfaceCorner h : out.ids()) {
    if (!out[h]) continue;
    const CutChartId c = whole.chartOf(h);
    const CutSurface::Chart& component = whole.charts[c];
    const bool isUseful = length[c] > kNotable * std::sqrt(component.area) &&
                          inside[c] <= kSh * all[c] && patches[c] <= std::max(kFew, component.triangles / kShare);
    out[h] = isUseful;
    isAny = isAny || isUseful;
  }
  return isAny ? out : Seams();
}

}  // namespace abflat
