#include "seam/crease_seams.h"

#include <cmath>

#include "base/constants.h"

namespace abflat {
namespace {

/// Cost of a seam in a crease, relative to its length.
constexpr double kMostCost = 0.6;
/// Length of a component's creases, relative to the root of its area.
constexpr double kLeastLength = 0.25;
/// Share of a component's curvature that may be elsewhere. If more is, the patches between creases
/// have to be cut in any case.
constexpr double kMostElsewhere = 0.3;
/// The most patches of a component: a few, and some for the root of its triangles. More are noise.
constexpr double kFewPatches = 64, kPatchesOfRoot = 1;

/// What is known of a component.
struct Component {
  double length = 0;  ///< of its creases
  double curvature = 0, elsewhere = 0;
  std::size_t patches = 0;

  bool isWorthIt(const CutSurface::Chart& whole) const {
    return length > kLeastLength * std::sqrt(whole.area) &&
           elsewhere <= kMostElsewhere * curvature &&
           static_cast<double>(patches) <=
               kFewPatches + kPatchesOfRoot * std::sqrt(static_cast<double>(whole.triangles));
  }
};

Seams allCreases(const SeamMesh& mesh) {
  Seams out(mesh.twin.size(), 0);
  for (const SurfaceCorner h : mesh.corners())
    out[h] = mesh.isOnSurface(h) && mesh.plainCost(h) < kMostCost * mesh.length[h];
  return out;
}

IdVector<CutChartId, Component> measure(const SeamMesh& mesh, const CutSurface& whole,
                                        const Seams& creases) {
  IdVector<CutChartId, Component> out(whole.charts.size());
  IdVector<SurfaceVertex, std::uint8_t> isOnCrease(mesh.vertexCount(), 0);
  for (const SurfaceCorner h : creases.ids()) {
    if (!creases[h]) continue;
    isOnCrease[mesh.tail(h)] = 1;
    out[whole.chartOf(h)].length += mesh.length[h] / 2;
  }
  for (const OpenVertex v : whole.vertices()) {
    if (whole.isBoundary[v]) continue;
    const SurfaceVertex i = whole.meshVertex[v];
    const double curvature = std::abs(2 * kPi - mesh.angleSum[i]);
    Component& component = out[whole.chartOf(v)];
    component.curvature += curvature;
    if (!isOnCrease[i]) component.elsewhere += curvature;
  }
  Seams all = creases;
  for (const SurfaceCorner h : all.ids())
    all[h] = all[h] || (mesh.twin[h].exists() && !whole.twin[h].exists());
  for (const CutSurface::Chart& patch : cutAlong(mesh, all).charts)
    ++out[whole.chartOfTriangle[patch.firstTriangle]].patches;
  return out;
}

}  // namespace

Seams creasesToBegin(const SeamMesh& mesh, const CutSurface& whole, double leastArea) {
  Seams out = allCreases(mesh);
  const IdVector<CutChartId, Component> components = measure(mesh, whole, out);
  bool isAny = false;
  for (const SurfaceCorner h : out.ids()) {
    const CutChartId c = whole.chartOf(h);
    const CutSurface::Chart& chart = whole.charts[c];
    out[h] = out[h] && whole.twin[h].exists() && chart.area >= leastArea &&
             components[c].isWorthIt(chart);
    isAny = isAny || out[h];
  }
  return isAny ? out : Seams();
}

}  // namespace abflat
