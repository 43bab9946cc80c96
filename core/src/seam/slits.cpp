#include "seam/slits.h"

#include <algorithm>
#include <cmath>

#include "base/stable_order.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

struct Peak {
  CutChartId chart;
  OpenVertex vertex;
  double stretch;
  double shift;  ///< |u - log-scale of the chart's mean|
};

bool isPeak(const CutSurface& s, const IdVector<OpenVertex, double>& own, OpenVertex v) {
  const SurfaceCorner first = s.outgoing[v];
  SurfaceCorner h = first;
  do {
    const OpenVertex w = s.head(h);
    if (own[w] > own[v] || (own[w] == own[v] && w < v)) return false;
    h = s.twin[prevCorner(h)];
  } while (h.exists() && h != first);
  return true;
}

/// For each chart above the bound that has no peak (as when its boundary is stretched most), adds
/// the vertex whose scale is farthest from the boundary's.
void addFarthest(const CutSurface& s, const IdVector<OpenVertex, double>& own,
                 const Prediction& prediction, const LogScales& u, double maxStretch,
                 std::vector<Peak>& peaks) {
  IdVector<CutChartId, std::uint8_t> hasPeak(s.charts.size(), 0);
  for (const Peak& peak : peaks) hasPeak[peak.chart] = 1;
  IdVector<CutChartId, OpenVertex> farthest(s.charts.size());
  const auto scale = [&](OpenVertex v) { return std::abs(u[s.meshVertex[v]]); };
  for (const OpenVertex v : s.vertices()) {
    const CutChartId c = s.chartOf(v);
    if (hasPeak[c] || s.isBoundary[v] || own[v] == 0 || !(prediction.stretch[c] > maxStretch))
      continue;
    if (!farthest[c].exists() || scale(v) > scale(farthest[c])) farthest[c] = v;
  }
  for (const CutChartId c : s.charts.ids())
    if (const OpenVertex v = farthest[c]; v.exists())
      peaks.push_back({c, v, own[v], prediction.shift(c, u[s.meshVertex[v]])});
}

}  // namespace

std::vector<OpenVertex> slitEnds(const CutPaths& paths, const Prediction& prediction,
                                 const LogScales& u, double maxStretch) {
  const SeamMesh& mesh = paths.mesh;
  const CutSurface& s = paths.surface;
  const PathForest& forest = paths.forest;
  // A slit to a peak in the front is the last resort.
  constexpr double kLeast = 1e-3;
  const auto ofStretch = [&](OpenVertex v) {
    return std::max(kLeast, 1 - mesh.frontAt(triangleOf(s.outgoing[v])));
  };
  IdVector<OpenVertex, double> own(s.vertexCount(), 1);
  for (const OpenVertex v : s.vertices()) {
    const double x = prediction.at(s.chartOf(v), u[s.meshVertex[v]]) - 1 + kinkStretch(mesh, s, v);
    own[v] = forest.distance[v] < kBarredCost ? 1 + ofStretch(v) * x : 0;
  }
  std::vector<Peak> peaks;
  for (const OpenVertex v : s.vertices()) {
    const CutChartId c = s.chartOf(v);
    if (s.isBoundary[v] || !(prediction.stretch[c] > maxStretch) || own[v] == 0) continue;
    if (isPeak(s, own, v))
      peaks.push_back({c, v, own[v], ofStretch(v) * prediction.shift(c, u[s.meshVertex[v]])});
  }
  addFarthest(s, own, prediction, u, maxStretch, peaks);
  sortStably(peaks, [](const Peak& a, const Peak& b) {
    if (a.chart != b.chart) return a.chart < b.chart;
    return a.stretch != b.stretch ? a.stretch > b.stretch : a.vertex < b.vertex;
  });
  // The most slits of a chart in one round: a quarter of the peaks that ask for one, so that a few
  // rounds are enough however many there are.
  constexpr std::size_t kFewPeaks = 32, kPart = 4;
  constexpr double kApart = 0.7;      // relative to the longer way to the boundary
  constexpr double kFarEnough = 0.3;  // relative to the greatest peak's way; nearer ones are noise
  // Relative to the greatest peak's shift. If little is missing, a superfluous slit costs more than
  // a round.
  constexpr double kMuch = 1.2, kShareOfMuch = 0.35, kShareOfLittle = 0.8;
  std::vector<OpenVertex> ends;
  for (std::size_t i = 0; i < peaks.size();) {
    const std::size_t first = ends.size();
    const double top = peaks[i].shift;
    const CutChartId chart = peaks[i].chart;
    const double share = prediction.stretch[chart] > kMuch ? kShareOfMuch : kShareOfLittle;
    const auto asks = [&](const Peak& peak) {
      return peak.shift >= share * top && peak.stretch > maxStretch;
    };
    std::size_t asking = 0;
    for (std::size_t k = i; k < peaks.size() && peaks[k].chart == chart; ++k)
      asking += asks(peaks[k]);
    const std::size_t most = std::max(kFewPeaks, asking / kPart);
    for (; i < peaks.size() && peaks[i].chart == chart; ++i) {
      const OpenVertex v = peaks[i].vertex;
      bool isFree = ends.size() - first < most && asks(peaks[i]);
      if (ends.size() > first && peaks[i].shift < kShareOfLittle * top)
        isFree = isFree && forest.distance[v] >= kFarEnough * forest.distance[ends[first]];
      for (std::size_t k = first; isFree && k < ends.size(); ++k)
        isFree = norm(edgeVector(mesh.positions, s.meshVertex[v], s.meshVertex[ends[k]])) >
                 kApart * std::max(forest.distance[v], forest.distance[ends[k]]);
      if (isFree || ends.size() == first) ends.push_back(v);
    }
  }
  return ends;
}

}  // namespace abflat
