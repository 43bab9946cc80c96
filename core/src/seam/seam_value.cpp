#include "seam/seam_value.h"

#include <algorithm>
#include <cmath>

#include "seam/prediction.h"

namespace abflat {

IdVector<CutChartId, double> costOfParts(const SeamMesh& mesh, const Seams& seams,
                                         const LogScales& u, double maxStretch,
                                         const IdVector<SurfaceTriangle, CutChartId>& partOf,
                                         std::size_t parts, const SeamPrices& prices) {
  constexpr double kBeyondBound = 10;  // times as bad
  IdVector<CutChartId, double> out(parts, 0);
  const double all = mesh.totalArea(), size = std::sqrt(all);
  if (!(all > 0)) return out;
  for (const SurfaceCorner h : seams.ids())
    if (seams[h] && mesh.isOnSurface(h)) out[partOf[triangleOf(h)]] += mesh.cost[h] / 2 / size;
  const CutSurface s = cutAlong(mesh, seams);
  const Prediction told = predictStretch(mesh, s, u);
  for (const CutChartId c : s.charts.ids()) {
    const SurfaceTriangle f = s.charts[c].firstTriangle;
    if (mesh.isFilling(f)) continue;
    const double beyond = std::max(0.0, told.stretch[c] - maxStretch);
    out[partOf[f]] += prices.chart + prices.ofStretch(told.stretch[c] + kBeyondBound * beyond) *
                                         s.charts[c].area / all;
  }
  return out;
}

}  // namespace abflat
