#include "seam/merge_trial.h"

#include <algorithm>
#include <utility>

#include "seam/log_scale.h"

namespace abflat {
namespace {

/// Joins charts of a cut surface along runs for as long as it lives, so that they can be extracted:
/// only edges and vertices of corners, which is much less than cutting the surface anew.
class JoinedForNow {
 public:
  JoinedForNow(const SeamMesh& mesh, const std::vector<SharedRun>& runs, CutSurface& surface)
      : mesh_(mesh), runs_(runs), s_(surface) {
    forEdges([&](SurfaceCorner h, SurfaceCorner o) {
      s_.twin[h] = o;
      s_.twin[o] = h;
    });
    forEdges([&](SurfaceCorner h, SurfaceCorner) {
      joinAround(h);
      joinAround(nextCorner(h));
    });
  }
  ~JoinedForNow() {
    forEdges([&](SurfaceCorner h, SurfaceCorner o) { s_.twin[h] = s_.twin[o] = SurfaceCorner(); });
    for (std::size_t i = changed_.size(); i-- > 0;)
      s_.vertexOfCorner[changed_[i].corner] = changed_[i].was;
  }
  JoinedForNow(const JoinedForNow&) = delete;
  JoinedForNow& operator=(const JoinedForNow&) = delete;

 private:
  struct Change {
    SurfaceCorner corner;
    OpenVertex was;
  };

  template <class Use>
  void forEdges(const Use& use) const {
    for (const SharedRun& run : runs_)
      for (const SurfaceCorner h : run.edges) use(h, mesh_.twin[h]);
  }

  void setVertex(SurfaceCorner c, OpenVertex v) {
    if (s_.vertexOfCorner[c] == v) return;
    changed_.push_back({c, s_.vertexOfCorner[c]});
    s_.vertexOfCorner[c] = v;
  }

  /// All corners around a vertex that hang together have that of the first.
  void joinAround(SurfaceCorner first) {
    const OpenVertex v = s_.vertexOfCorner[first];
    SurfaceCorner c = rotateCounterClockwise(s_.twin, first);
    for (; c.exists() && c != first; c = rotateCounterClockwise(s_.twin, c)) setVertex(c, v);
    if (c.exists()) return;
    for (c = rotateClockwise(s_.twin, first); c.exists(); c = rotateClockwise(s_.twin, c))
      setVertex(c, v);
  }

  const SeamMesh& mesh_;
  const std::vector<SharedRun>& runs_;
  CutSurface& s_;
  std::vector<Change> changed_;
};

}  // namespace

MergeTrial::MergeTrial(const SeamWork& work, const std::vector<RunsTogether>& all,
                       std::optional<CutSurface>& apart, const Listener& listener)
    : whole_(&work.mesh) {
  std::vector<SharedRun> runs;
  for (const RunsTogether& together : all)
    runs.insert(runs.end(), together.begin(), together.end());
  constexpr std::size_t kMost = 2;  // times as many: the elimination order is for the whole
  IdVector<CutChartId, std::uint8_t> isJoined(apart->charts.size(), 0);
  for (const SharedRun& run : runs) isJoined[run.a] = isJoined[run.b] = 1;
  std::size_t triangles = 0;
  for (const CutChartId c : apart->charts.ids())
    if (isJoined[c]) triangles += apart->charts[c].triangles;
  if (kMost * triangles < work.mesh.triangleCount()) {
    tryPart(work, runs, *apart, isJoined, listener);
    return;
  }
  tryWhole(work, cutAlong(work.mesh, work.seams, listener), std::move(*apart));
  apart.reset();
}

void MergeTrial::tryWhole(const SeamWork& work, CutSurface joined, CutSurface apart) {
  apart_ = std::move(apart);
  joined_ = std::move(joined);
  u_ = work.scale.solve(joined_, {});
  if (!u_.empty()) told_ = predictStretch(work.mesh, joined_, u_);
  before_ = predictStretch(work.mesh, apart_, work.u);
}

void MergeTrial::tryPart(const SeamWork& work, const std::vector<SharedRun>& runs,
                         CutSurface& apart, const IdVector<CutChartId, std::uint8_t>& isJoined,
                         const Listener& listener) {
  IdVector<SurfaceCorner, std::uint8_t> isRun(work.mesh.twin.size(), 0);
  for (const SharedRun& run : runs)
    for (const SurfaceCorner h : run.edges) isRun[h] = isRun[work.mesh.twin[h]] = 1;
  {
    const JoinedForNow joined(work.mesh, runs, apart);
    part_ = std::make_unique<SeamPart>(extractCharts(work.mesh, apart, isJoined, listener));
  }
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
