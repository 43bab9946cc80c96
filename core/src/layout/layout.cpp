#include "layout/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/constants.h"
#include "base/point2.h"
#include "base/portable_math.h"
#include "base/stable_order.h"
#include "layout/diameter.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// Logarithm of the length and heading (radians) per half-edge, for an arbitrary first edge.
struct EdgePolars {
  IdVector<ChartCorner, double> logLength;
  IdVector<ChartCorner, double> heading;
};

EdgePolars carryEdges(const DiskChart& chart, const std::vector<double>& x) {
  EdgePolars e;
  e.logLength.resize(x.size());
  e.heading.resize(x.size());
  IdVector<ChartTriangle, std::uint8_t> reached(chart.triangleCount(), 0);
  std::vector<ChartCorner> queue{ChartCorner(0)};  // half-edges through which triangles are entered
  queue.reserve(chart.triangleCount());
  reached[ChartTriangle(0)] = 1;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const ChartCorner h = queue[i], n = nextCorner(h), p = prevCorner(h);
    // Sine rule: length of an edge over the sine of the opposite corner.
    const double logRatio = e.logLength[h] - portable::log(portable::sin(x[p]));
    e.logLength[n] = logRatio + portable::log(portable::sin(x[h]));
    e.logLength[p] = logRatio + portable::log(portable::sin(x[n]));
    e.heading[n] = std::remainder(e.heading[h] + kPi - x[n], 2 * kPi);
    e.heading[p] = std::remainder(e.heading[h] + kPi + x[h], 2 * kPi);
    for (const ChartCorner g : {h, n, p}) {
      const ChartCorner t = chart.twin[g];
      if (!t.exists() || reached[triangleOf(t)]) continue;
      reached[triangleOf(t)] = 1;
      e.logLength[t] = e.logLength[g];
      e.heading[t] = std::remainder(e.heading[g] + kPi, 2 * kPi);
      queue.push_back(t);
    }
  }
  return e;
}

/// One half-edge per edge of the minimum spanning tree by length (Kruskal).
std::vector<ChartCorner> spanningEdges(const DiskChart& chart,
                                       const IdVector<ChartCorner, double>& logLength) {
  std::vector<ChartCorner> edges;
  for (const ChartCorner h : chart.corners())
    if (!chart.twin[h].exists() || h < chart.twin[h]) edges.push_back(h);
  sortStably(edges, [&](ChartCorner a, ChartCorner b) { return logLength[a] < logLength[b]; });
  IdVector<ChartVertex, ChartVertex> parent(chart.vertexCount());
  for (const ChartVertex v : chart.vertices()) parent[v] = v;
  const auto find = [&](ChartVertex v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::vector<ChartCorner> tree;
  tree.reserve(chart.vertexCount());
  for (const ChartCorner h : edges) {
    const ChartVertex a = find(chart.vertexOfCorner[h]);
    const ChartVertex b = find(chart.vertexOfCorner[nextCorner(h)]);
    if (a == b) continue;
    parent[a] = b;
    tree.push_back(h);
  }
  return tree;
}

/// A vertex to place, and the vector to it from a vertex placed earlier.
struct Placement {
  ChartVertex from, to;
  double logLength, heading;
};

/// The tree's edges in an order in which they can be placed, from vertex 0.
std::vector<Placement> orderPlacements(const DiskChart& chart, const EdgePolars& e,
                                       const std::vector<ChartCorner>& tree) {
  std::vector<std::uint32_t> offset(chart.vertexCount() + 1, 0);
  const auto ends = [&](ChartCorner h) {
    return std::array<ChartVertex, 2>{chart.vertexOfCorner[h], chart.vertexOfCorner[nextCorner(h)]};
  };
  for (const ChartCorner h : tree)
    for (const ChartVertex v : ends(h)) ++offset[v + 1];
  std::partial_sum(offset.begin(), offset.end(), offset.begin());
  std::vector<std::uint32_t> fill(offset.begin(), offset.end() - 1);
  std::vector<ChartCorner> incident(offset.back());
  for (const ChartCorner h : tree)
    for (const ChartVertex v : ends(h)) incident[fill[v]++] = h;

  std::vector<Placement> order;
  order.reserve(tree.size());
  IdVector<ChartVertex, std::uint8_t> placed(chart.vertexCount(), 0);
  ChartVertex v(0);
  placed[v] = 1;
  for (std::size_t next = 0;; v = order[next++].to) {
    for (std::uint32_t i = offset[v]; i < offset[v + 1]; ++i) {
      const ChartCorner h = incident[i];
      const auto [a, b] = ends(h);
      const ChartVertex to = a == v ? b : a;
      if (placed[to]) continue;
      placed[to] = 1;
      order.push_back({v, to, e.logLength[h], e.heading[h] + (a == v ? 0 : kPi)});
    }
    if (next == order.size()) return order;
  }
}

/// Placement of the whole layout: applied before coordinates are summed up, so that it costs no
/// precision.
struct Frame {
  double rotation = 0, logScale = 0;
  Point2 origin{0, 0};  ///< of vertex 0
};

std::vector<double> place(const DiskChart& chart, const std::vector<Placement>& order,
                          const Frame& frame) {
  std::vector<double> uv(2 * chart.vertices().size());
  setPoint(uv, 0, frame.origin);
  for (const Placement& p : order) {
    const double length = portable::exp(p.logLength + frame.logScale);
    const double heading = p.heading + frame.rotation;
    const Point2 from = pointAt(uv, p.from);
    setPoint(
        uv, p.to,
        {from[0] + length * portable::cos(heading), from[1] + length * portable::sin(heading)});
  }
  return uv;
}

double areaUv(const DiskChart& chart, const std::vector<double>& uv) {
  double area = 0;
  for (const ChartTriangle f : chart.surfaceTriangles()) {
    const auto [a, b, c] = pointsOf(uv, verticesOf(chart.vertexOfCorner, f));
    area += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
  }
  return area;
}

IdVector<BoundaryIndex, Point2> boundaryPoints(const DiskChart& chart,
                                               const std::vector<double>& uv) {
  IdVector<BoundaryIndex, Point2> points;
  for (const ChartCorner h : chart.boundary) points.push_back(pointAt(uv, chart.vertexOfCorner[h]));
  return points;
}

/// The rotation that makes the longest diameter horizontal. Of the two candidates, takes the one
/// with the boundary's points further to the right; if they balance, the one with the diameter's
/// first vertex on the left.
double findRotation(const DiskChart& chart, const IdVector<BoundaryIndex, Point2>& points) {
  constexpr double kBalanced = 1e-7;  // of the diameter, per point
  // Ties are broken by chart vertex, not by position in the loop, which may begin anywhere.
  std::vector<Point2> byVertex(chart.vertexCount(), points.front());
  for (const BoundaryIndex i : points.ids()) byVertex[chart.boundaryVertex(i)] = points[i];
  const auto [first, second] = diameter(byVertex);
  const Point2 &a = byVertex[first], &b = byVertex[second];
  const Point2 axis{b[0] - a[0], b[1] - a[1]}, middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
  double skew = 0;
  for (const Point2& p : points)
    skew += (p[0] - middle[0]) * axis[0] + (p[1] - middle[1]) * axis[1];
  const double scale = axis[0] * axis[0] + axis[1] * axis[1];
  const bool turned = skew < -kBalanced * scale * static_cast<double>(points.size());
  return -portable::atan2(axis[1], axis[0]) + (turned ? kPi : 0);
}

Frame finalFrame(const DiskChart& chart, const std::vector<Placement>& order) {
  Frame frame;
  double longest = -std::numeric_limits<double>::infinity();
  for (const Placement& p : order) longest = std::max(longest, p.logLength);
  frame.logScale = -longest;  // avoids overflow
  std::vector<double> uv = place(chart, order, frame);
  const IdVector<BoundaryIndex, Point2> points = boundaryPoints(chart, uv);
  frame.rotation = findRotation(chart, points);
  const double area = areaUv(chart, uv), wanted = surfaceArea(chart);
  // A layout that is folded over itself may have no area; it keeps its size and the checks reject
  // it.
  if (area > 0 && wanted > 0) frame.logScale += portable::log(wanted / area) / 2;
  uv = place(chart, order, frame);
  Point2 low{0, 0};
  for (const Point2& p : boundaryPoints(chart, uv))
    for (std::size_t d = 0; d < 2; ++d) low[d] = std::min(low[d], p[d]);
  frame.origin = {-low[0], -low[1]};
  return frame;
}

}  // namespace

std::vector<double> layOut(const DiskChart& chart, const std::vector<double>& angles) {
  const EdgePolars edges = carryEdges(chart, angles);
  const std::vector<Placement> order =
      orderPlacements(chart, edges, spanningEdges(chart, edges.logLength));
  return place(chart, order, finalFrame(chart, order));
}

}  // namespace abflat
