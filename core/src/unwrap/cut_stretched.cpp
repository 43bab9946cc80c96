#include "unwrap/cut_stretched.h"

#include <algorithm>
#include <utility>

#include "refine/refine.h"
#include "seam/closed_charts.h"
#include "seam/prediction.h"
#include "unwrap/find_within.h"
#include "unwrap/seam_options.h"

namespace abflat {
namespace {

/// The charts of these triangles, as they are cut now.
struct ChartsNow {
  const SeamPart part;
  const CutSurface cut;
  const Prediction expected;
};

ChartsNow chartsNow(const OpenSurface& open, SeamPart part) {
  Seams seams = part.ofCorners(open.seams);
  for (const SurfaceCorner h : seams.ids()) seams[h] = seams[h] && part.mesh.twin[h].exists();
  CutSurface cut = cutAlong(part.mesh, seams);
  Prediction expected = predictStretch(part.mesh, cut, part.ofVertices(open.scale));
  return {std::move(part), std::move(cut), std::move(expected)};
}

/// Restores the seams of a chart to their length before shortening; false if they already have it.
bool restore(const ChartsNow& now, CutChartId chart, OpenSurface& open) {
  bool isAny = false;
  for (const SurfaceTriangle f : now.cut.trianglesOf(chart))
    for (const SurfaceCorner i : cornersOf(f)) {
      const SurfaceCorner h = now.part.wholeHalfEdge[i];
      const SurfaceVertex v = open.mesh.tail(h);
      if (!now.cut.isBoundary[now.cut.tail(i)]) open.scale[v] = open.foundScale[v];
      if (open.seams[h] || !open.found[h] || !open.mesh.twin[h].exists()) continue;
      open.seams[h] = isAny = true;
    }
  return isAny;
}

/// The larger value of each chart and its mirror image, so that both are cut alike. All charts are
/// there if the surface has a mirror.
IdVector<CutChartId, double> withImages(const OpenSurface& open, const ChartsNow& now,
                                        IdVector<CutChartId, double> excess) {
  if (!open.mirror) return excess;
  const CutSurface& s = now.cut;
  const IdVector<SurfaceCorner, SurfaceCorner> inPart =
      now.part.cornersInPart(open.mesh.twin.size());
  IdVector<CutChartId, CutChartId> image(excess.size());
  for (const SurfaceCorner h : open.mirror.image.ids()) {
    const SurfaceCorner there = open.mirror.image[h];
    // The mirror turns the surface around, so what is on the left comes to the right.
    if (there.exists() && s.twin[inPart[h]].exists())
      image[s.chartOf(inPart[h])] = s.chartOf(inPart[open.mesh.twin[there]]);
  }
  IdVector<CutChartId, double> out = excess;
  for (const CutChartId c : image.ids())
    if (image[c].exists() && image[image[c]] == c)
      out[image[c]] = std::max(out[image[c]], excess[c]);
  return out;
}

/// Whether much of the surface, cut symmetrically, was stretched much more than expected.
bool isWorseThanExpected(const OpenSurface& open, const CutSurface& s,
                         const IdVector<CutChartId, double>& excess) {
  constexpr double kMuchMore = 1.35, kMuch = 0.5;
  double area = 0;
  for (const CutChartId c : s.charts.ids())
    if (excess[c] > kMuchMore) area += s.charts[c].area;
  return !open.otherwise.seams.empty() && area > kMuch * open.mesh.totalArea();
}

/// Goes back to the seams that symmetric ones were preferred to.
void takeOther(OpenSurface& open) {
  open.mirror = Mirror();
  open.seams = std::move(open.otherwise.seams);
  open.found = std::move(open.otherwise.found);
  open.scale = std::move(open.otherwise.scale);
  open.foundScale = std::move(open.otherwise.foundScale);
  open.otherwise = KnownSeams();
}

}  // namespace

Further cutStretched(const ChartSet& set, const IdVector<ChartId, Stretched>& charts,
                     const UnwrapOptions& options, ThreadPool& pool, const Listener& listener,
                     OpenSurface& open) {
  const auto isAsked = [](const Stretched& chart) { return chart.stretch > 0; };
  std::vector<SurfaceTriangle> first;
  for (const ChartId i : charts.ids())
    if (isAsked(charts[i]) || open.mirror) first.push_back(set.topology(i).triangles.front());
  if (std::none_of(charts.begin(), charts.end(), isAsked)) return Further::Nothing;
  const ChartsNow now = chartsNow(open, extractClosed(open.mesh, open.seams, open.given, first));
  const CutSurface& s = now.cut;
  const Prediction& expected = now.expected;
  const IdVector<SurfaceCorner, SurfaceCorner> inPart =
      now.part.cornersInPart(open.mesh.twin.size());
  IdVector<CutChartId, double> excess(s.charts.size(), 0);  // 0: leave the chart alone
  bool isAnyRestored = false;
  for (const ChartId i : charts.ids()) {
    if (!isAsked(charts[i])) continue;
    const CutChartId c = s.chartOf(inPart[cornerOf(set.topology(i).triangles.front(), 0)]);
    if (charts[i].isInvalid && restore(now, c, open)) {
      isAnyRestored = true;
      continue;
    }
    const double told = (expected.stretch[c] - 1) / expected.excess[c];
    if (!(told > 0)) continue;
    // Above kMost the distortion is not due to area alone: add one seam, and let flattening tell.
    constexpr double kMost = 8, kSlightly = 1.01;
    const auto above = [&](double x) {
      return stretchBeforeRefining(x, Energy(options.balance)) - 1;
    };
    const double leastToCut = kSlightly * above(options.maxStretch) / told;
    // Invalid charts have not been refined.
    const double found = charts[i].isInvalid ? std::max((charts[i].stretch - 1) / told, leastToCut)
                                             : above(charts[i].stretch) / told;
    excess[c] = expected.leeway[c] * std::min(found, std::max(kMost, leastToCut));
  }
  if (isWorseThanExpected(open, s, excess)) {
    takeOther(open);
    return Further::Replaced;
  }
  open.otherwise = KnownSeams();
  excess = withImages(open, now, std::move(excess));
  open.mesh.excess.resize(open.mesh.triangleCount(), 1);
  for (const SurfaceTriangle f : now.part.mesh.triangles())
    if (const double x = excess[s.chartOfTriangle[f]]; x > 0)
      open.mesh.excess[triangleOf(now.part.wholeHalfEdge[cornerOf(f, 0)])] = x;
  std::vector<SurfaceTriangle> toCut;
  for (const CutChartId c : s.charts.ids())
    if (excess[c] > 0)
      toCut.push_back(triangleOf(now.part.wholeHalfEdge[cornerOf(s.charts[c].firstTriangle, 0)]));
  SeamReport found;
  const bool isAnyFound =
      findWithin(extractClosed(open.mesh, open.seams, open.given, toCut),
                 seamOptions(options, open, pool, listener, open.variant), open, found);
  return isAnyFound || isAnyRestored ? Further::Cut : Further::Nothing;
}

}  // namespace abflat
