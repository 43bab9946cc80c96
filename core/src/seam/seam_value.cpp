#include "seam/seam_value.h"

#include <algorithm>
#include <cmath>

namespace abflat {

double SeamPrices::ofStretch(double s) const {
  constexpr double kInexact = 0.002;
  const double x = std::max(0.0, s - 1);
  return stretch * x + inexact * std::min(1.0, std::sqrt(x / kInexact));
}

double costOfSeams(const SeamMesh& mesh, const Seams& seams) {
  double sum = 0;
  for (const SurfaceCorner h : seams.ids())
    if (seams[h] && mesh.isOnSurface(h)) sum += mesh.cost[h] / 2;
  return sum;
}

double costOfAll(const SeamMesh& mesh, const Seams& seams, const CutSurface& s,
                 const Prediction& told, const SeamPrices& prices) {
  double stretch = 0, area = 0;
  for (const CutChartId c : s.charts.ids()) {
    area += s.charts[c].area;
    stretch += s.charts[c].area * prices.ofStretch(told.stretch[c]);
  }
  return area > 0 ? costOfSeams(mesh, seams) / std::sqrt(area) + stretch / area : 0;
}

IdVector<CutChartId, double> costOfParts(const SeamMesh& mesh, const Seams& seams,
                                         const LogScales& u, double maxStretch,
                                         const IdVector<SurfaceTriangle, CutChartId>& partOf,
                                         std::size_t parts, const SeamPrices& prices) {
  constexpr double kBeyondBound = 10;  // times as bad
  constexpr double kExact = 1e-6;
  IdVector<CutChartId, double> out(parts, 0);
  IdVector<CutChartId, double> area(parts, 0);
  IdVector<CutChartId, std::uint8_t> isExact(parts, 1);
  for (const SurfaceTriangle f : mesh.triangles()) area[partOf[f]] += mesh.area[f];
  for (const SurfaceCorner h : seams.ids())
    if (seams[h] && mesh.isOnSurface(h))
      out[partOf[triangleOf(h)]] += mesh.cost[h] / 2 / std::sqrt(area[partOf[triangleOf(h)]]);
  const CutSurface s = cutAlong(mesh, seams);
  const Prediction told = predictStretch(mesh, s, u);
  for (const CutChartId c : s.charts.ids()) {
    const SurfaceTriangle f = s.charts[c].firstTriangle;
    if (mesh.isFilling(f)) continue;
    isExact[partOf[f]] &= told.stretch[c] <= 1 + kExact;
    const double beyond = std::max(0.0, told.stretch[c] - maxStretch);
    out[partOf[f]] += prices.chart + prices.ofStretch(told.stretch[c] + kBeyondBound * beyond) *
                                         s.charts[c].area / area[partOf[f]];
  }
  for (const CutChartId part : out.ids())
    if (!isExact[part]) out[part] += prices.anyInexact;
  return out;
}

double costOfWhole(const SeamMesh& mesh, const Seams& seams, const LogScales& u, double maxStretch,
                   const SeamPrices& prices) {
  const IdVector<SurfaceTriangle, CutChartId> one(mesh.triangleCount(), CutChartId(0));
  return costOfParts(mesh, seams, u, maxStretch, one, 1, prices).front();
}

}  // namespace abflat
