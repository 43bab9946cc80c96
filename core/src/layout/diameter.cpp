#include "layout/diameter.h"

#include <algorithm>

#include "base/stable_order.h"

namespace abflat {
namespace {

double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double squaredDistance(const Point2& a, const Point2& b) {
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

}  // namespace

std::vector<std::uint32_t> convexHull(const std::vector<Point2>& points) {
  std::vector<std::uint32_t> order = stableOrder(
      points.size(), [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
  order.erase(std::unique(order.begin(), order.end(),
                          [&](std::uint32_t a, std::uint32_t b) { return points[a] == points[b]; }),
              order.end());
  if (order.size() < 3) return order;
  std::vector<std::uint32_t> hull(2 * order.size());
  std::size_t n = 0;
  const auto add = [&](std::uint32_t p, std::size_t floor) {
    while (n >= floor && turn(points[hull[n - 2]], points[hull[n - 1]], points[p]) <= 0) --n;
    hull[n++] = p;
  };
  for (const std::uint32_t p : order) add(p, 2);
  const std::size_t lower = n + 1;
  for (std::size_t i = order.size() - 1; i-- > 0;) add(order[i], lower);
  hull.resize(n - 1);
  return hull;
}

std::array<std::uint32_t, 2> diameter(const std::vector<Point2>& points) {
  constexpr double kTie = 1 - 1e-7;  // of squared lengths
  const std::vector<std::uint32_t> hull = convexHull(points);
  if (hull.empty()) return {0, 0};
  const std::size_t n = hull.size();
  double longest = 0;
  std::vector<std::array<std::uint32_t, 2>> candidates{{hull[0], hull[0]}};
  const auto consider = [&](std::uint32_t p, std::uint32_t q) {
    const double length = squaredDistance(points[p], points[q]);
    if (length < kTie * longest) return;
    if (kTie * length > longest) candidates.clear();
    longest = std::max(longest, length);
    candidates.push_back({std::min(p, q), std::max(p, q)});
  };
  std::size_t j = n > 1 ? 1 : 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t a = hull[i], b = hull[(i + 1) % n];
    for (;;) {
      consider(a, hull[j]);
      consider(b, hull[j]);
      const std::size_t next = (j + 1) % n;
      // A parallel edge has two far ends; rounding must not hide one of them.
      if (next != i) consider(a, hull[next]), consider(b, hull[next]);
      if (next == i || turn(points[a], points[b], points[hull[next]]) <=
                           turn(points[a], points[b], points[hull[j]]))
        break;
      j = next;
    }
  }
  std::array<std::uint32_t, 2> best{hull[0], hull[0]};
  for (const auto& c : candidates)
    if (best[0] == best[1] ||
        (squaredDistance(points[c[0]], points[c[1]]) >= kTie * longest && c < best))
      best = c;
  return best;
}

}  // namespace abflat
