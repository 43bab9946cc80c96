#include "layout/diameter.h"

#include <algorithm>

namespace abflat {
namespace {

double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double squaredDistance(const Point2& a, const Point2& b) {
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

}  // namespace

std::vector<Point2> convexHull(std::vector<Point2> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point2> hull(2 * points.size());
  std::size_t n = 0;
  const auto add = [&](const Point2& p, std::size_t floor) {
    while (n >= floor && turn(hull[n - 2], hull[n - 1], p) <= 0) --n;
    hull[n++] = p;
  };
  for (const Point2& p : points) add(p, 2);
  const std::size_t lower = n + 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  hull.resize(n - 1);
  return hull;
}

std::array<Point2, 2> diameter(const std::vector<Point2>& points) {
  const std::vector<Point2> hull = convexHull(points);
  if (hull.empty()) return {};
  const std::size_t n = hull.size();
  std::array<Point2, 2> best{hull[0], hull[n - 1]};
  std::size_t j = n > 1 ? 1 : 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 &a = hull[i], &b = hull[(i + 1) % n];
    for (;;) {
      for (const Point2* p : {&a, &b})
        if (squaredDistance(*p, hull[j]) > squaredDistance(best[0], best[1])) best = {*p, hull[j]};
      const std::size_t next = (j + 1) % n;
      if (next == i || turn(a, b, hull[next]) <= turn(a, b, hull[j])) break;
      j = next;
    }
  }
  if (best[1] < best[0]) std::swap(best[0], best[1]);
  return best;
}

}  // namespace abflat
