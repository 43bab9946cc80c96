#include "seam/chart_length.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace abflat {
namespace {

using Distances = IdVector<OpenVertex, double>;

/// Distances along edges, within the chart of `from`.
Distances distancesFrom(const CutSurface& s, const IdVector<OpenVertex, PlanePoint>& at,
                        OpenVertex from) {
  Distances out(s.vertexCount(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, OpenVertex>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  out[from] = 0;
  queue.push({0, from});
  const auto reach = [&](OpenVertex v, double sum) {
    if (!(sum < out[v])) return;
    out[v] = sum;
    queue.push({sum, v});
  };
  while (!queue.empty()) {
    const auto [sum, v] = queue.top();
    queue.pop();
    if (sum > out[v]) continue;
    const SurfaceCorner first = s.outgoing[v];
    for (SurfaceCorner h = first; h.exists();) {
      for (const OpenVertex w : {s.head(h), s.tail(prevCorner(h))})
        reach(w, sum + distance(at[v], at[w]));
      h = s.twin[prevCorner(h)];
      if (h == first) break;
    }
  }
  return out;
}

BoundaryIndex farthest(const CutSurface& s, const BoundaryLoop& loop, const Distances& from) {
  BoundaryIndex out(0);
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (from[s.tail(loop[BoundaryIndex(i)])] > from[s.tail(loop[out])]) out = BoundaryIndex(i);
  return out;
}

/// The first place on one side of a chart that is at least so far from the first end.
template <typename Side>
std::size_t firstFrom(const Side& side, double reached) {
  const auto isBefore = [](const auto& stop, double x) { return stop.reached < x; };
  return static_cast<std::size_t>(std::lower_bound(side.begin(), side.end(), reached, isBefore) -
                                  side.begin());
}

template <typename Side>
std::size_t nearest(const Side& side, double reached) {
  const std::size_t next = firstFrom(side, reached);
  const bool isBefore = next > 0 && (next == side.size() || reached - side[next - 1].reached <
                                                                side[next].reached - reached);
  return isBefore ? next - 1 : next;
}

}  // namespace

ChartLength::ChartLength(const CutSurface& surface, const IdVector<OpenVertex, PlanePoint>& at,
                         CutChartId chart, const IdVector<OpenVertex, std::uint8_t>& isPreferred) {
  const BoundaryLoop loop = surface.outline(chart);
  const auto vertex = [&](BoundaryIndex i) { return surface.tail(loop[i]); };
  const Distances fromAny = distancesFrom(surface, at, vertex(BoundaryIndex(0)));
  const BoundaryIndex first = farthest(surface, loop, fromAny);
  const Distances from = distancesFrom(surface, at, vertex(first));
  const BoundaryIndex last = farthest(surface, loop, from);
  length_ = from[vertex(last)];
  const std::size_t n = loop.size();
  const auto walk = [&](std::size_t step, Side& side) {
    double reached = 0;
    for (BoundaryIndex i = first; i != last; i = BoundaryIndex((i + step) % n)) {
      reached = std::max(reached, from[vertex(i)]);
      side.push_back(
          {vertex(i), at[vertex(i)], reached, !isPreferred.empty() && isPreferred[vertex(i)] != 0});
    }
  };
  walk(1, after_);
  walk(n - 1, before_);
}

bool ChartLength::hasPreferred() const {
  constexpr double kEnd = 0.1;  // of the length
  return std::any_of(before_.begin(), before_.end(), [&](const Stop& stop) {
    return stop.isPreferred && stop.reached > kEnd * length_ && stop.reached < (1 - kEnd) * length_;
  });
}

/// The nearest place before the first end that is about so far from it; a preferred one if there
/// is.
std::size_t ChartLength::stopNear(double reached, double reach) const {
  std::size_t out = nearest(before_, reached);
  double least = reach;
  for (std::size_t i = firstFrom(before_, reached - reach);
       i < before_.size() && before_[i].reached <= reached + reach; ++i) {
    const double off = std::abs(before_[i].reached - reached);
    if (!before_[i].isPreferred || off >= least) continue;
    least = off;
    out = i;
  }
  return out;
}

/// The nearest vertex on the other side that is about as far from the first end: the way there is
/// straight across.
std::size_t ChartLength::opposite(const Stop& stop, double reach) const {
  std::size_t i = firstFrom(after_, stop.reached - reach);
  std::size_t out = i;
  for (; i < after_.size() && after_[i].reached <= stop.reached + reach; ++i)
    if (distance(stop.at, after_[i].at) < distance(stop.at, after_[out].at)) out = i;
  return out;
}

std::vector<AcrossPlace> ChartLength::places(int parts) const {
  constexpr double kReach = 0.3, kReachOfPreferred = 0.5;  // of a part
  std::vector<AcrossPlace> out;
  std::size_t onBefore = 0, onAfter = 0;  // the first end belongs to both sides
  for (int i = 1; i < parts; ++i) {
    const std::size_t before = stopNear(length_ * i / parts, kReachOfPreferred * length_ / parts);
    if (before <= onBefore) continue;
    const std::size_t after = opposite(before_[before], kReach * length_ / parts);
    if (after <= onAfter || after == after_.size()) continue;
    onBefore = before;
    onAfter = after;
    out.push_back({before_[before].vertex, after_[after].vertex});
  }
  return out;
}

}  // namespace abflat
