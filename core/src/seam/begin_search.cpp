#include "seam/begin_search.h"

#include <utility>

#include "seam/pockets.h"
#include "seam/prediction.h"
#include "seam/symmetric_seams.h"

namespace abflat {
namespace {

/// For each chart the vertex of most extreme scale, such as the tip of something that sticks out.
IdVector<CutChartId, OpenVertex> extremes(const CutSurface& s, const Prediction& p,
                                          const LogScales& u) {
  IdVector<CutChartId, OpenVertex> out(s.charts.size());
  for (const OpenVertex v : s.vertices()) {
    const CutChartId c = s.chartOf(v);
    if (!out[c].exists() || p.at(c, u[s.meshVertex[v]]) > p.at(c, u[s.meshVertex[out[c]]]))
      out[c] = v;
  }
  return out;
}

/// Where closed charts are best opened; none if there are no closed ones.
IdVector<CutChartId, OpenVertex> rootsOf(const SeamMesh& mesh, const CutSurface& s,
                                         LogScale& solver) {
  std::vector<OpenVertex> closed;
  for (const CutSurface::Chart& c : s.charts)
    if (c.loops == 0) closed.push_back(s.tail(cornerOf(c.firstTriangle, 0)));
  if (closed.empty()) return {};
  const LogScales u = solver.solve(s, closed);
  if (u.empty()) return {};
  return extremes(s, predictStretch(mesh, s, u), u);
}

}  // namespace

BegunSearch beginSearch(const SeamMesh& mesh, Seams given, const SeamOptions& options,
                        const std::vector<SurfaceCorner>& doubled, LogScale& solver) {
  const Listener& listener = options.listener;
  Seams seams = std::move(given);
  for (const SurfaceCorner h : options.first.ids())
    if (options.first[h] && mesh.twin[h].exists()) seams[h] = 1;
  const Seams before = seams;
  const CutSurface s = cutAlong(mesh, seams, listener);
  const TopologyCut cut = cutToDisks(mesh, s, rootsOf(mesh, s, solver), seams, listener);
  openPockets(mesh, doubled, seams, listener);
  if (options.mirror) addImages(mesh, options.mirror, before, seams, listener);
  return {std::move(seams), GivenCharts(s), cut};
}

}  // namespace abflat
