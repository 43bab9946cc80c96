#include "pack/outline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/stable_order.h"

namespace abflat {
namespace {

PlanePoint pointOf(const PackShape& shape, std::uint32_t v) {
  return {shape.uv[2 * v], shape.uv[2 * v + 1]};
}

double doubleArea(PlanePoint a, PlanePoint b, PlanePoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double doubleArea(const PackShape& shape, std::size_t t) {
  return doubleArea(pointOf(shape, shape.triangles[t]), pointOf(shape, shape.triangles[t + 1]),
                    pointOf(shape, shape.triangles[t + 2]));
}

void addLoop(Loops& loops, const PackShape& shape, const std::uint32_t* vertices,
             std::size_t count) {
  if (loops.points.empty()) loops.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) loops.points.push_back(pointOf(shape, vertices[i]));
  loops.ends.push_back(static_cast<std::uint32_t>(loops.points.size()));
  loops.isGroup.push_back(1);
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Edges of the positively oriented triangles that no other such triangle shares, sorted.
std::vector<Edge> boundaryEdges(const PackShape& shape) {
  struct Side {
    Edge edge;  ///< the smaller vertex first
    int direction;
  };
  std::vector<Side> sides;
  for (std::size_t t = 0; t + 2 < shape.triangles.size(); t += 3) {
    if (!(doubleArea(shape, t) > 0)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = shape.triangles[t + k], b = shape.triangles[t + (k + 1) % 3];
      sides.push_back({{std::min(a, b), std::max(a, b)}, a < b ? 1 : -1});
    }
  }
  sortStably(sides, [](const Side& a, const Side& b) { return a.edge < b.edge; });
  std::vector<Edge> out;
  for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
    int sum = 0;
    for (; j < sides.size() && sides[j].edge == sides[i].edge; ++j) sum += sides[j].direction;
    const auto [a, b] = sides[i].edge;
    out.insert(out.end(), static_cast<std::size_t>(std::abs(sum)),
               sum > 0 ? Edge(a, b) : Edge(b, a));
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// As many edges end at each vertex as begin there, so every walk along unused edges closes.
void addBoundary(Loops& loops, const PackShape& shape) {
  const std::vector<Edge> edges = boundaryEdges(shape);
  std::vector<std::uint8_t> isUsed(edges.size(), 0);
  std::vector<std::uint32_t> walk;
  const auto firstFrom = [&](std::uint32_t v) {
    const auto place = std::lower_bound(edges.begin(), edges.end(), Edge(v, 0));
    return static_cast<std::size_t>(place - edges.begin());
  };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (isUsed[i]) continue;
    walk.clear();
    for (std::size_t at = i;;) {
      isUsed[at] = 1;
      walk.push_back(edges[at].first);
      if (edges[at].second == edges[i].first) break;
      for (at = firstFrom(edges[at].second); isUsed[at];) ++at;
    }
    addLoop(loops, shape, walk.data(), walk.size());
    loops.isGroup.back() = 0;
  }
  if (!edges.empty()) loops.isGroup.back() = 1;
}

bool isLess(PlanePoint a, PlanePoint b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

}  // namespace

Loops coveringLoops(const PackShape& shape) {
  Loops out;
  if (shape.outline.empty())
    addBoundary(out, shape);
  else
    addLoop(out, shape, shape.outline.data(), shape.outline.size());
  for (std::size_t t = 0; t + 2 < shape.triangles.size(); t += 3)
    if (!(doubleArea(shape, t) > 0)) addLoop(out, shape, shape.triangles.data() + t, 3);
  return out;
}

Mass massOf(const PackShape& shape) {
  Mass out;
  if (shape.triangles.empty()) return out;
  const PlanePoint origin = pointOf(shape, shape.triangles[0]);
  PlanePoint sum;
  for (std::size_t t = 0; t + 2 < shape.triangles.size(); t += 3) {
    const double area = std::abs(doubleArea(shape, t)) / 2;
    out.area += area;
    for (std::size_t k = 0; k < 3; ++k) {
      const PlanePoint p = pointOf(shape, shape.triangles[t + k]);
      sum.x += area / 3 * (p.x - origin.x);
      sum.y += area / 3 * (p.y - origin.y);
    }
  }
  out.center = origin;
  if (out.area > 0) out.center = {origin.x + sum.x / out.area, origin.y + sum.y / out.area};
  return out;
}

Mass massOf(const std::vector<PlanePoint>& polygon) {
  Mass out;
  const PlanePoint o = polygon.front();
  PlanePoint sum;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const PlanePoint a = polygon[i], b = polygon[i + 1];
    const double area = doubleArea(o, a, b) / 2;
    out.area += area;
    sum.x += area / 3 * (a.x + b.x - 2 * o.x);
    sum.y += area / 3 * (a.y + b.y - 2 * o.y);
  }
  out.center = o;
  if (out.area > 0) out.center = {o.x + sum.x / out.area, o.y + sum.y / out.area};
  return out;
}

std::vector<PlanePoint> convexHull(std::vector<PlanePoint> points) {
  sortStably(points, isLess);
  points.erase(std::unique(points.begin(), points.end(),
                           [](PlanePoint a, PlanePoint b) { return a.x == b.x && a.y == b.y; }),
               points.end());
  std::vector<PlanePoint> hull;
  const auto wrap = [&hull](PlanePoint p, std::size_t least) {
    while (hull.size() >= least && !(doubleArea(hull[hull.size() - 2], hull.back(), p) > 0))
      hull.pop_back();
    hull.push_back(p);
  };
  for (const PlanePoint& p : points) wrap(p, 2);
  const std::size_t lower = hull.size() + 1;
  for (std::size_t i = points.size(); i-- > 0;) wrap(points[i], lower);
  if (hull.size() > 1) hull.pop_back();
  return hull;
}

}  // namespace abflat
