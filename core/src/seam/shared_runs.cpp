#include "seam/shared_runs.h"

#include <algorithm>

namespace abflat {
namespace {

void addRuns(const SeamMesh& mesh, const Seams& kept, const CutSurface& s, CutChartId chart,
             std::vector<SharedRun>& out) {
  const BoundaryLoop loop = s.outline(chart);
  const std::size_t n = loop.size();
  std::size_t start = 0;  // index where a run begins
  const auto behindAt = [&](std::size_t i) {
    return chartBehind(mesh, kept, s, loop[BoundaryIndex(i % n)]);
  };
  while (start < n && behindAt(start) == behindAt(start + n - 1)) ++start;
  if (start == n) return;  // a single chart goes all the way round
  CutChartId last;
  for (std::size_t i = 0; i < n; ++i) {
    const BoundaryIndex at((start + i) % n);
    const SurfaceCorner h = loop[at];
    const CutChartId other = chartBehind(mesh, kept, s, h);
    const bool isNew = other != last;
    last = other;
    if (!other.exists() || other <= chart || !s.charts[other].isDisk()) continue;
    if (isNew) out.push_back({chart, other, {}, at, 0, 0});
    out.back().add(mesh, h);
  }
}

}  // namespace

CutChartId chartBehind(const SeamMesh& mesh, const Seams& kept, const CutSurface& s,
                       SurfaceCorner h) {
  return kept[h] || !mesh.isOnSurface(h) ? CutChartId() : s.chartOf(mesh.twin[h]);
}

std::vector<SharedRun> sharedRuns(const SeamMesh& mesh, const Seams& kept, const CutSurface& s) {
  std::vector<SharedRun> out;
  for (const CutChartId c : s.charts.ids())
    if (s.charts[c].isDisk()) addRuns(mesh, kept, s, c, out);
  return out;
}

OutlinePairs pairsOf(const SeamMesh& mesh, const CutSurface& s, const SharedRun& run,
                     const Outline& a) {
  const BoundaryLoop loop = s.outline(run.b);
  const std::size_t n = a.size(), m = loop.size();
  const auto first = std::find(loop.begin(), loop.end(), mesh.twin[run.edges.front()]);
  const auto begin = static_cast<std::size_t>(first - loop.begin());
  OutlinePairs pairs;
  for (std::size_t i = 0; i <= run.edges.size(); ++i)
    pairs.emplace_back((run.begin + i) % n, (begin + 1 + m - i) % m);
  return pairs;
}

}  // namespace abflat
