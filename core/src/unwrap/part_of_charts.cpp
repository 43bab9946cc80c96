#include "unwrap/part_of_charts.h"

#include <algorithm>

#include "seam/geometric_order.h"

namespace abflat {

SeamPart partOfCharts(const LaidCharts& charts, const OpenSurface& open,
                      const IdVector<ChartId, std::uint8_t>& isWanted) {
  if (std::find(isWanted.begin(), isWanted.end(), 0) == isWanted.end())
    return inGeometricOrder(open.mesh);
  const CutSurface cut = cutAlong(open.mesh, open.seams);
  IdVector<CutChartId, std::uint8_t> isWantedCut(cut.charts.size(), 0);
  for (const ChartId i : charts.set.ids())
    isWantedCut[cut.chartOfTriangle[charts.set.topology(i).triangles.front()]] = isWanted[i];
  const SeamPart between = extractCharts(open.mesh, cut, isWantedCut);
  SeamPart out = inGeometricOrder(between.mesh);
  out.embedIn(between);
  return out;
}

}  // namespace abflat
