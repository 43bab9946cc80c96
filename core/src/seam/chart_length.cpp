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

double distance(PlanePoint a, PlanePoint b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

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

}  // namespace

ChartLength::ChartLength(const CutSurface& surface, const IdVector<OpenVertex, PlanePoint>& at,
                         CutChartId chart) {
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
      side.push_back({vertex(i), reached});
    }
  };
  walk(1, after_);
  walk(n - 1, before_);
}

std::vector<AcrossPlace> ChartLength::places(int parts) const {
  std::vector<AcrossPlace> out;
  std::size_t onBefore = 0, onAfter = 0;  // the first end belongs to both sides
  const auto nearest = [](const Side& side, double to) {
    const auto isShort = [](const Stop& stop, double x) { return stop.reached < x; };
    const auto next = std::lower_bound(side.begin(), side.end(), to, isShort);
    if (next == side.begin()) return std::size_t{0};
    const auto before = std::prev(next);
    const bool isBefore = next == side.end() || to - before->reached < next->reached - to;
    return static_cast<std::size_t>((isBefore ? before : next) - side.begin());
  };
  for (int i = 1; i < parts; ++i) {
    const double to = length_ * i / parts;
    const std::size_t before = nearest(before_, to), after = nearest(after_, to);
    if (before <= onBefore || after <= onAfter) continue;
    onBefore = before;
    onAfter = after;
    out.push_back({before_[before].vertex, after_[after].vertex});
  }
  return out;
}

}  // namespace abflat
