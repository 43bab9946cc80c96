#include "boundary/move_apart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/number_text.h"
#include "base/point2.h"
#include "base/portable_math.h"
#include "boundary/blamed_arc.h"
#include "boundary/carry_along.h"
#include "layout/pose.h"
#include "mesh/triangle_geometry.h"
#include "refine/straight_parts.h"

namespace abflat {
namespace {

/// Each round checks the boundary once, and moves what still crosses twice as far.
constexpr int kRounds = 16;
/// Relative to the least height of the triangles around a vertex. A triangle keeps its orientation
/// if none of its three corners moves farther than this.
constexpr double kMostOfHeight = 0.2;

/// The boundary of one layout, and how far each of its places may move into the chart. A straight
/// run moves with its two ends.
class Outline {
 public:
  Outline(const DiskChart& chart, const std::vector<double>& uv, const StraightPlaces& straight)
      : chart_(chart), uv_(uv), straight_(chart, straight), shift_(chart.boundary.size(), 0) {
    for (const BoundaryIndex k : shift_.ids()) movedBy_.push_back({k, k});
    if (!straight.empty()) findEnds(straight);
    findNormals();
    findRoom();
  }

  /// Moves the places of the arcs further; false if none of them has room left.
  bool moveOn(const Crossings& crossings, const std::vector<double>& turned, double first) {
    const std::size_t n = shift_.size();
    std::vector<int> begun(2 * n + 1, 0);
    for (const auto& [i, j] : crossings.first) {
      const Arc arc = blamedArc(i, j, turned);
      ++begun[arc.first % n];
      --begun[arc.first % n + arc.count];
    }
    for (std::size_t k = 1; k < 2 * n; ++k) begun[k] += begun[k - 1];
    IdVector<BoundaryIndex, std::uint8_t> isAsked(n, 0);
    for (const BoundaryIndex k : shift_.ids())
      if (begun[k] + begun[k + n] > 0)
        for (const BoundaryIndex end : movedBy_[k]) isAsked[end] = 1;
    bool isAny = false;
    for (const BoundaryIndex k : shift_.ids()) {
      if (isAsked[k] == 0) continue;
      const double now = std::min(room_[k], std::max(first, 2 * shift_[k]));
      isAny = isAny || now > shift_[k];
      shift_[k] = now;
    }
    return isAny;
  }

  /// From now on places may move as far as that, and carry along what lies around them. Not where
  /// something has to stay straight.
  bool goDeep(double deepest) {
    constexpr double kLongest = 2;
    const bool isStraight = straight_.begin() != straight_.end();
    if (isStraight || !(deepest > 0)) return false;
    isDeep_ = true;
    for (double& room : room_) room = std::max(room, deepest);
    for (Point2& way : normal_) {
      const double length = portable::hypot(way[0], way[1]);
      if (length > kLongest)
        for (double& x : way) x *= kLongest / length;
    }
    return true;
  }

  std::vector<double> moved() const {
    if (isDeep_) return carriedAlong(chart_, uv_, shift_, normal_);
    std::vector<double> out = uv_;
    for (const BoundaryIndex k : shift_.ids()) {
      if (shift_[k] == 0) continue;
      for (std::size_t d = 0; d < 2; ++d)
        out[2 * chart_.boundaryVertex(k) + d] += shift_[k] * normal_[k][d];
    }
    straight_.straighten(out);
    return out;
  }

  double farthest() const { return *std::max_element(shift_.begin(), shift_.end()); }
  std::size_t movedCount() const {
    const auto isMoved = [&](const Ends& ends) {
      return shift_[ends[0]] > 0 || shift_[ends[1]] > 0;
    };
    return static_cast<std::size_t>(std::count_if(movedBy_.begin(), movedBy_.end(), isMoved));
  }

 private:
  /// The places whose moves decide where a place goes: the ends of its straight run, or itself.
  using Ends = std::array<BoundaryIndex, 2>;

  void findEnds(const StraightPlaces& straight) {
    for (const BoundaryIndex from : straight.ids()) {
      if (straight[from] != 0) continue;
      BoundaryIndex to = chart_.after(from);
      while (straight[to] != 0) to = chart_.after(to);
      for (BoundaryIndex k = chart_.after(from); k != to; k = chart_.after(k))
        movedBy_[k] = {from, to};
    }
  }

  /// Unit vector to the left of the edge that leaves a place.
  Point2 leftOf(BoundaryIndex place) const {
    const Point2 a = pointAt(uv_, chart_.boundaryVertex(place));
    const Point2 b = pointAt(uv_, chart_.boundaryVertex(chart_.after(place)));
    const double x = b[0] - a[0], y = b[1] - a[1];
    const double length = portable::hypot(x, y);
    return length > 0 ? Point2{-y / length, x / length} : Point2{0, 0};
  }

  /// The vector that moves both edges of a corner into the chart by 1. Where the chart wraps around
  /// the corner, as at the end of a slit, half the sum of their normals, which is tiny there.
  Point2 inwards(const Point2& a, const Point2& b) const {
    constexpr double kSharpest = 1e-4;  // for 1 + cos: limits the move to 141 times as much
    const bool isConvex = a[0] * b[1] - a[1] * b[0] > 0;
    const double both = isConvex ? std::max(1 + a[0] * b[0] + a[1] * b[1], kSharpest) : 2;
    return {(a[0] + b[0]) / both, (a[1] + b[1]) / both};
  }

  void findNormals() {
    for (const BoundaryIndex k : shift_.ids())
      normal_.push_back(inwards(leftOf(chart_.before(k)), leftOf(k)));
  }

  /// The least height of a triangle.
  double heightOf(ChartTriangle f) const {
    const auto p = pointsOf(uv_, verticesOf(chart_.vertexOfCorner, f));
    const auto [a, b, c] = p;
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double *from = p[k], *to = p[(k + 1) % 3];
      longest = std::max(longest, portable::hypot(to[0] - from[0], to[1] - from[1]));
    }
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    return longest > 0 ? std::abs(area) / longest : 0;
  }

  void findRoom() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    IdVector<ChartVertex, double> height(chart_.vertexCount(), kInfinity);
    for (const ChartTriangle f : chart_.triangles()) {
      const double least = heightOf(f);
      for (const ChartCorner c : cornersOf(f)) {
        double& at = height[chart_.vertexOfCorner[c]];
        at = std::min(at, least);
      }
    }
    for (const BoundaryIndex k : shift_.ids())
      room_.push_back(kMostOfHeight * height[chart_.boundaryVertex(k)]);
    for (const BoundaryIndex k : shift_.ids())
      for (const BoundaryIndex end : movedBy_[k]) room_[end] = std::min(room_[end], room_[k]);
  }

  const DiskChart& chart_;
  const std::vector<double>& uv_;
  const StraightParts straight_;
  IdVector<BoundaryIndex, Ends> movedBy_;
  IdVector<BoundaryIndex, Point2> normal_;
  IdVector<BoundaryIndex, double> room_, shift_;
  bool isDeep_ = false;
};

double extentOf(const DiskChart& chart, const std::vector<double>& uv) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double lo[2] = {kInfinity, kInfinity}, hi[2] = {-kInfinity, -kInfinity};
  for (const BoundaryIndex i : chart.boundary.ids()) {
    const Point2 p = pointAt(uv, chart.boundaryVertex(i));
    for (std::size_t d = 0; d < 2; ++d) {
      lo[d] = std::min(lo[d], p[d]);
      hi[d] = std::max(hi[d], p[d]);
    }
  }
  return std::max(hi[0] - lo[0], hi[1] - lo[1]);
}

}  // namespace

MovedBack moveBack(const TouchingLayout& layout, const MoveLengths& lengths, Crossings left,
                   const std::function<Crossings(const std::vector<double>&)>& crossings) {
  MovedBack out;
  Outline outline(layout.chart, layout.uv, layout.straight);
  bool isDeep = false;
  for (int round = 0; round < kRounds && left.count > 0; ++round) {
    while (!outline.moveOn(left, layout.turned, lengths.first)) {
      if (isDeep || !outline.goDeep(lengths.deepest)) return out;
      isDeep = true;
    }
    out.uv = outline.moved();
    left = crossings(out.uv);
  }
  out.isApart = left.count == 0 && !out.uv.empty();
  out.moved = outline.movedCount();
  out.farthest = outline.farthest();
  return out;
}

std::string movedBackNote(const MovedBack& back, const DiskChart& chart) {
  return "the boundary touched itself; " + std::to_string(back.moved) +
         " of its vertices were pulled back by up to " +
         withDigits(back.farthest / extentOf(chart, back.uv), 1) + " of its extent";
}

Attempt movedApart(ChartFlattener& flattener, const Attempt& crossing, double deepest) {
  const DiskChart& chart = flattener.chart();
  Attempt out = crossing;
  const double cells = flattener.leastDistance(crossing.uv);
  // Condition (9) holds exactly at its limit, so moved edges would violate it.
  const bool isDelaunay = !crossing.solution.activeEdge.empty();
  if (isDelaunay || !(cells > 0)) return out;
  const std::vector<double> turned = turnedAlong(boundaryAngles(chart, crossing.solution));
  const auto crossings = [&](const std::vector<double>& uv) { return flattener.crossings(uv); };
  const MoveLengths lengths{cells, deepest * extentOf(chart, crossing.uv)};
  MovedBack back = moveBack({chart, crossing.uv, flattener.straight(), turned}, lengths,
                            crossing.validity.crossings, crossings);
  if (!back.isApart) return out;
  out.uv = back.uv;
  fitArea(chart, out.uv);
  flattener.measure(out);
  if (out.validity.flippedTriangles > 0) return crossing;
  out.fallbacks.push_back(movedBackNote(back, chart));
  return out;
}

}  // namespace abflat
