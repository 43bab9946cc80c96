#include "unwrap/expect_scale.h"

#include <algorithm>

#include "seam/extract_charts.h"
#include "seam/log_scale.h"

namespace abflat {

void expectScale(const ChartSet& set, const IdVector<ChartId, std::uint8_t>& isAsked,
                 ThreadPool& pool, OpenSurface& open) {
  if (std::find(isAsked.begin(), isAsked.end(), 1) == isAsked.end()) return;
  const CutSurface s = cutAlong(open.mesh, open.seams);
  IdVector<CutChartId, std::uint8_t> isWanted(s.charts.size(), 0);
  for (const ChartId i : set.ids())
    isWanted[s.chartOfTriangle[set.topology(i).triangles.front()]] = isAsked[i];
  const SeamPart part = extractCharts(open.mesh, s, isWanted);
  LogScale scale(part.mesh, &pool, part.ofVertices(open.eliminationRanks));
  const CutSurface whole = cutAlong(part.mesh, Seams(part.mesh.twin.size(), 0));
  const LogScales u = scale.solve(whole, {});
  for (const SurfaceVertex v : u.ids()) open.scale[part.wholeVertex[v]] = u[v];
}

}  // namespace abflat
