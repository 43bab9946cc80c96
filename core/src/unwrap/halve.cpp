#include "unwrap/halve.h"

#include <algorithm>

#include "hole/fill_holes.h"
#include "seam/halve_charts.h"

namespace abflat {

bool halve(const ChartSet& set, const IdVector<ChartId, std::uint8_t>& isAsked,
           const UnwrapOptionValues& options, OpenSurface& open,
           IdVector<ChartId, std::uint8_t>& isWhole) {
  isWhole.assign(set.size(), 0);
  if (std::find(isAsked.begin(), isAsked.end(), 1) == isAsked.end()) return false;
  open.seams.resize(open.mesh.twin.size(), 0);
  open.found.resize(open.mesh.twin.size(), 0);
  const CutSurface s = cutAlong(open.mesh, open.seams);
  const auto cutChartOf = [&](ChartId i) {
    return s.chartOfTriangle[set.topology(i).triangles.front()];
  };
  IdVector<CutChartId, std::uint8_t> isWanted(s.charts.size(), 0);
  for (const ChartId i : set.ids()) isWanted[cutChartOf(i)] = isAsked[i];
  const IdVector<CutChartId, std::uint8_t> isHalved =
      halveCharts(open.mesh, s, isWanted, open.seams);
  openTouchedHoles(open.mesh, cutAlong(open.mesh, open.seams), options.fillHoles, open.seams);
  for (const SurfaceCorner h : open.seams.ids()) open.found[h] = open.found[h] || open.seams[h];
  bool isAny = false;
  for (const ChartId i : set.ids()) {
    isWhole[i] = isAsked[i] && !isHalved[cutChartOf(i)];
    isAny = isAny || isHalved[cutChartOf(i)];
  }
  return isAny;
}

}  // namespace abflat
