#include "seam/chords.h"

#include <algorithm>
#include <cmath>

namespace abflat {
namespace {

/// Of a chart's area; less is next to nothing.
constexpr double kNotableShare = 0.02;

double lengthForArea(const Chord& c) { return c.length / std::sqrt(std::min(c.left, c.right)); }

}  // namespace

ChordFinder::ChordFinder(const CutPaths& paths)
    : paths_(paths),
      surface_(paths.surface),
      parent_(paths.mesh.triangleCount()),
      area_(paths.mesh.area),
      alongLoop_(surface_.vertexCount()) {}

void ChordFinder::walk(CutChartId chart) {
  const SurfaceTriangle root = surface_.charts[chart].firstTriangle;
  order_.assign(1, root);
  parent_[root] = SurfaceCorner();
  for (std::size_t i = 0; i < order_.size(); ++i)
    for (const SurfaceCorner h : cornersOf(order_[i])) {
      const SurfaceCorner o = surface_.twin[h];
      // On a disk no triangle is met twice; if the chart were not a disk, the walk would still end.
      if (!o.exists()) continue;
      const SurfaceTriangle next = triangleOf(o);
      if (next == root || parent_[next].exists() || paths_.forest.isTreeEdge(surface_, h)) continue;
      parent_[next] = o;
      order_.push_back(next);
    }
  for (std::size_t i = order_.size(); i-- > 1;)
    area_[triangleOf(surface_.twin[parent_[order_[i]]])] += area_[order_[i]];
}

void ChordFinder::numberLoop(CutChartId chart) {
  const BoundaryLoop loop = surface_.outline(chart);
  for (const BoundaryIndex i : loop.ids()) alongLoop_[surface_.tail(loop[i])] = i;
}

/// The share of the pairs whose half-edges end up in different charts.
double ChordFinder::resolvedShare(SurfaceCorner h,
                                  const std::vector<std::array<BoundaryIndex, 2>>& pairs) const {
  const auto endOf = [&](OpenVertex v) { return alongLoop_[paths_.forest.source[v]]; };
  const std::pair<BoundaryIndex, BoundaryIndex> ends =
      std::minmax(endOf(surface_.tail(h)), endOf(surface_.head(h)));
  const auto isBetween = [&](BoundaryIndex i) { return i >= ends.first && i < ends.second; };
  std::size_t resolved = 0;
  for (const auto& pair : pairs) resolved += isBetween(pair[0]) != isBetween(pair[1]);
  return static_cast<double>(resolved) / static_cast<double>(pairs.size());
}

/// h is none if the chord would cut off a smaller share or open a hole that has to stay filled.
Chord ChordFinder::chordAt(SurfaceCorner h, CutChartId chart, double leastShare) const {
  const double all = surface_.charts[chart].area;
  Chord c;
  c.left = area_[triangleOf(h)];
  c.right = all - c.left;
  c.length = paths_.costThrough(h);
  if (!(std::min(c.left, c.right) > leastShare * all) || !(c.length < kBarredCost)) return {};
  c.h = h;
  return c;
}

Chord ChordFinder::best(CutChartId chart, const std::vector<std::array<BoundaryIndex, 2>>& pairs) {
  walk(chart);
  numberLoop(chart);
  Chord best;
  double bestScore = 0;
  for (std::size_t i = 1; i < order_.size(); ++i) {
    const SurfaceCorner h = parent_[order_[i]];
    Chord c = chordAt(h, chart, kNotableShare);
    if (!c.h.exists()) continue;
    double score = lengthForArea(c);
    if (best.h.exists() && score >= bestScore) continue;
    constexpr double kUnresolved = 3;  // a chord that resolves all pairs may be this much longer
    c.resolved = pairs.empty() ? 1 : resolvedShare(h, pairs);
    score *= 1 + (kUnresolved - 1) * (1 - c.resolved);
    if (!best.h.exists() || score < bestScore) {
      best = c;
      bestScore = score;
    }
  }
  return best;
}

/// `chart` has been walked.
Chord ChordFinder::bestApart(CutChartId chart,
                             const std::vector<std::array<BoundaryIndex, 2>>& pairs,
                             double leastShare) const {
  Chord best;
  double bestScore = 0;
  for (std::size_t i = 1; i < order_.size(); ++i) {
    Chord c = chordAt(parent_[order_[i]], chart, leastShare);
    if (!c.h.exists()) continue;
    const double score = lengthForArea(c);
    if (best.h.exists() && score >= bestScore) continue;
    c.resolved = resolvedShare(c.h, pairs);
    if (!(c.resolved > 0) || (best.h.exists() && score / c.resolved >= bestScore)) continue;
    best = c;
    bestScore = score / c.resolved;
  }
  return best;
}

Chord ChordFinder::apart(CutChartId chart, const std::vector<std::array<BoundaryIndex, 2>>& pairs) {
  walk(chart);
  numberLoop(chart);
  // A scrap is better than a seam that costs many times as much, through a flat face, say.
  constexpr double kManyTimes = 5;
  const Chord notable = bestApart(chart, pairs, kNotableShare), any = bestApart(chart, pairs, 0);
  const auto scoreOf = [](const Chord& c) { return lengthForArea(c) / c.resolved; };
  const bool isWorth = notable.h.exists() && scoreOf(notable) < kManyTimes * scoreOf(any);
  return isWorth ? notable : any;
}

Chord ChordFinder::forHalving(CutChartId chart) {
  Chord most = best(chart, {});
  if (most.h.exists()) return most;
  for (std::size_t i = 1; i < order_.size(); ++i) {
    const Chord c = chordAt(parent_[order_[i]], chart, 0);
    const bool isMore = std::min(c.left, c.right) > std::min(most.left, most.right);
    if (c.h.exists() && (!most.h.exists() || isMore)) most = c;
  }
  return most;
}

}  // namespace abflat
