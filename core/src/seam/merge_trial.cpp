#include "seam/merge_trial.h"

#include <algorithm>
#include <utility>

#include "seam/log_scale.h"

namespace abflat {

MergeTrial::MergeTrial(const SeamWork& work, const std::vector<RunsTogether>& all, CutSurface apart,
                       const Listener& listener)
    : whole_(&work.mesh) {
  std::vector<SharedRun> runs;
  for (const RunsTogether& together : all)
    runs.insert(runs.end(), together.begin(), together.end());
  constexpr std::size_t kMost = 2;  // times as many: the elimination order is for the whole
  CutSurface s = cutAlong(work.mesh, work.seams, listener);
  IdVector<CutChartId, std::uint8_t> isUnion(s.charts.size(), 0);
  for (const SharedRun& run : runs) isUnion[s.chartOf(run.edges.front())] = 1;
  std::size_t triangles = 0;
  for (const CutChartId c : s.charts.ids())
    if (isUnion[c]) triangles += s.charts[c].triangles;
  if (kMost * triangles < work.mesh.triangleCount())
    tryPart(work, runs, s, isUnion, listener);
  else
    tryWhole(work, std::move(s), std::move(apart));
}

void MergeTrial::tryWhole(const SeamWork& work, CutSurface joined, CutSurface apart) {
  apart_ = std::move(apart);
  joined_ = std::move(joined);
  u_ = work.scale.solve(joined_, {});
  if (!u_.empty()) told_ = predictStretch(work.mesh, joined_, u_);
  before_ = predictStretch(work.mesh, apart_, work.u);
}

void MergeTrial::tryPart(const SeamWork& work, const std::vector<SharedRun>& runs,
                         const CutSurface& joined,
                         const IdVector<CutChartId, std::uint8_t>& isUnion,
                         const Listener& listener) {
  IdVector<SurfaceCorner, std::uint8_t> isRun(work.mesh.twin.size(), 0);
  for (const SharedRun& run : runs)
    for (const SurfaceCorner h : run.edges) isRun[h] = isRun[work.mesh.twin[h]] = 1;
  part_ = std::make_unique<SeamPart>(extractCharts(work.mesh, joined, isUnion, listener));
  const SeamMesh& mesh = part_->mesh;
  Seams between;
  for (const SurfaceCorner h : part_->wholeHalfEdge) between.push_back(isRun[h]);
  EliminationRanks ranks = part_->ofVertices(work.scale.eliminationRanks());
  joined_ = cutAlong(mesh, Seams(between.size(), 0), listener);
  apart_ = cutAlong(mesh, between, listener);
  u_ = LogScale(mesh, work.options.pool, std::move(ranks)).solve(joined_, {});
  if (!u_.empty()) told_ = predictStretch(mesh, joined_, u_);
  before_ = predictStretch(mesh, apart_, part_->ofVertices(work.u));
}

SurfaceCorner MergeTrial::inTrial(SurfaceCorner h) const {
  if (!part_) return h;
  const auto& all = part_->wholeHalfEdge;
  return SurfaceCorner(std::lower_bound(all.begin(), all.end(), h) - all.begin());
}

std::vector<CutChartId> MergeTrial::partsOf(const RunsTogether& runs) const {
  std::vector<CutChartId> out;
  for (const SharedRun& run : runs) {
    const SurfaceCorner h = inTrial(run.edges.front());
    out.push_back(apart_.chartOf(h));
    out.push_back(apart_.chartOf(mesh().twin[h]));
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace abflat
