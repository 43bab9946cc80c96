#include "unwrap/cut_stretched.h"

#include <algorithm>
#include <utility>

#include "refine/refine.h"
#include "seam/prediction.h"
#include "unwrap/find_within.h"
#include "unwrap/seam_options.h"

namespace abflat {
namespace {

/// Seams that separate charts. Slits within a chart do not count, unless they are given.
Seams seamsBetween(const CutSurface& s, const OpenSurface& open) {
  Seams out = open.seams;
  for (const SurfaceCorner h : out.ids()) {
    const SurfaceCorner o = open.mesh.twin[h];
    if (o.exists() && s.chartOf(h) == s.chartOf(o) && !open.isGiven(h)) out[h] = 0;
  }
  return out;
}

/// Restores the seams of a chart to their length before shortening; false if they already have it.
bool restore(const CutSurface& s, CutChartId chart, OpenSurface& open) {
  bool isAny = false;
  for (const SurfaceTriangle f : s.trianglesOf(chart))
    for (const SurfaceCorner h : cornersOf(f)) {
      const SurfaceVertex v = open.mesh.tail(h);
      if (!s.isBoundary[s.tail(h)]) open.scale[v] = open.foundScale[v];
      if (open.seams[h] || !open.found[h] || !open.mesh.twin[h].exists()) continue;
      open.seams[h] = isAny = true;
    }
  return isAny;
}

/// The larger value of each chart and its mirror image, so that both are cut alike.
IdVector<CutChartId, double> withImages(const OpenSurface& open, const CutSurface& s,
                                        IdVector<CutChartId, double> excess) {
  IdVector<CutChartId, CutChartId> image(excess.size());
  for (const SurfaceCorner h : open.mirror.image.ids()) {
    const SurfaceCorner there = open.mirror.image[h];
    // The mirror turns the surface around, so what is on the left comes to the right.
    if (there.exists() && s.twin[h].exists())
      image[s.chartOf(h)] = s.chartOf(open.mesh.twin[there]);
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
  if (std::none_of(charts.begin(), charts.end(), isAsked)) return Further::Nothing;
  const CutSurface s = cutAlong(open.mesh, open.seams);
  const Prediction expected = predictStretch(open.mesh, s, open.scale);
  IdVector<CutChartId, double> excess(s.charts.size(), 0);  // 0: leave the chart alone
  bool isAnyRestored = false;
  for (const ChartId i : charts.ids()) {
    if (!isAsked(charts[i])) continue;
    const CutChartId c = s.chartOfTriangle[set.topology(i).triangles.front()];
    if (charts[i].isInvalid && restore(s, c, open)) {
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
  excess = withImages(open, s, std::move(excess));
  open.mesh.excess.resize(open.mesh.triangleCount(), 1);
  for (const SurfaceTriangle f : open.mesh.triangles())
    if (const double x = excess[s.chartOfTriangle[f]]; x > 0) open.mesh.excess[f] = x;
  const CutSurface apart = cutAlong(open.mesh, seamsBetween(s, open));
  IdVector<CutChartId, std::uint8_t> isWanted(apart.charts.size(), 0);
  for (const CutChartId c : s.charts.ids())
    if (excess[c] > 0) isWanted[apart.chartOfTriangle[s.charts[c].firstTriangle]] = 1;
  SeamReport found;
  const bool isAnyFound = findWithin(
      apart, isWanted, seamOptions(options, open, pool, listener, open.variant), open, found);
  return isAnyFound || isAnyRestored ? Further::Cut : Further::Nothing;
}

}  // namespace abflat
