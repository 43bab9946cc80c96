#include "boundary/move_apart.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/portable_math.h"
#include "boundary/guilty_arc.h"

namespace abflat {
namespace {

/// Each takes a test of the boundary, and moves what still crosses twice as far.
constexpr int kRounds = 16;
/// Of the least height of the triangles round a vertex. A triangle whose three corners move by so
/// much keeps its orientation.
constexpr double kMostOfHeight = 0.2;

struct Vector {
  double x = 0, y = 0;
};

/// The boundary of one layout, and how far each of its places may move into the chart.
class Outline {
 public:
  Outline(const DiskChart& chart, const std::vector<double>& uv, const StraightPlaces& straight)
      : chart_(chart), uv_(uv), shift_(chart.boundary.size(), 0) {
    findNormals();
    findRoom();
    for (std::size_t i = 0; i < straight.size(); ++i)
      if (straight[i] != 0) room_[i] = 0;
  }

  /// Moves the places of the arcs on; false where none of them has room left.
  bool moveOn(const Crossings& crossings, const std::vector<double>& turned, double first) {
    const std::size_t n = shift_.size();
    std::vector<int> begun(2 * n + 1, 0);
    for (const auto& [i, j] : crossings.first) {
      const Arc arc = guiltyArc(i, j, turned);
      ++begun[arc.first % n];
      --begun[arc.first % n + arc.count];
    }
    bool isAny = false;
    for (std::size_t k = 1; k < 2 * n; ++k) begun[k] += begun[k - 1];
    for (std::size_t k = 0; k < n; ++k) {
      if (begun[k] + begun[k + n] == 0) continue;
      const double now = std::min(room_[k], std::max(first, 2 * shift_[k]));
      isAny = isAny || now > shift_[k];
      shift_[k] = now;
    }
    return isAny;
  }

  std::vector<double> moved() const {
    std::vector<double> out = uv_;
    for (std::size_t k = 0; k < shift_.size(); ++k) {
      if (shift_[k] == 0) continue;
      const std::size_t v = vertex(k);
      out[2 * v] += shift_[k] * normal_[k].x;
      out[2 * v + 1] += shift_[k] * normal_[k].y;
    }
    return out;
  }

  double farthest() const { return *std::max_element(shift_.begin(), shift_.end()); }
  std::size_t movedCount() const {
    return shift_.size() - static_cast<std::size_t>(std::count(shift_.begin(), shift_.end(), 0.0));
  }

 private:
  std::size_t vertex(std::size_t place) const {
    return chart_.vertexOfCorner[chart_.boundary[place]];
  }

  /// Of length 1, to the left of the edge from a to b.
  Vector leftOf(std::size_t a, std::size_t b) const {
    const double x = uv_[2 * b] - uv_[2 * a], y = uv_[2 * b + 1] - uv_[2 * a + 1];
    const double length = portable::hypot(x, y);
    return length > 0 ? Vector{-y / length, x / length} : Vector{};
  }

  /// What takes both edges of a corner into the chart by 1. Where the chart is round a corner, as
  /// at the end of a slit, half the sum of their normals: hardly any there.
  Vector inwards(const Vector& a, const Vector& b) const {
    constexpr double kSharpest = 1e-4;  // of 1 + cos: moves by up to 141 times as much
    const bool isConvex = a.x * b.y - a.y * b.x > 0;
    const double both = isConvex ? std::max(1 + a.x * b.x + a.y * b.y, kSharpest) : 2;
    return {(a.x + b.x) / both, (a.y + b.y) / both};
  }

  void findNormals() {
    const std::size_t n = shift_.size();
    for (std::size_t k = 0; k < n; ++k)
      normal_.push_back(inwards(leftOf(vertex((k + n - 1) % n), vertex(k)),
                                leftOf(vertex(k), vertex((k + 1) % n))));
  }

  void findRoom() {
    std::vector<double> height(chart_.vertexCount(), std::numeric_limits<double>::infinity());
    for (std::uint32_t f = 0; f < chart_.triangleCount(); ++f) {
      const std::uint32_t* v = &chart_.vertexOfCorner[3 * f];
      double longest = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double *a = &uv_[2 * std::size_t{v[k]}], *b = &uv_[2 * std::size_t{v[(k + 1) % 3]}];
        longest = std::max(longest, portable::hypot(b[0] - a[0], b[1] - a[1]));
      }
      const double *a = &uv_[2 * std::size_t{v[0]}], *b = &uv_[2 * std::size_t{v[1]}],
                   *c = &uv_[2 * std::size_t{v[2]}];
      const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      const double least = longest > 0 ? std::abs(area) / longest : 0;
      for (std::size_t k = 0; k < 3; ++k) height[v[k]] = std::min(height[v[k]], least);
    }
    for (std::size_t k = 0; k < shift_.size(); ++k)
      room_.push_back(kMostOfHeight * height[vertex(k)]);
  }

  const DiskChart& chart_;
  const std::vector<double>& uv_;
  std::vector<Vector> normal_;
  std::vector<double> room_, shift_;
};

double extentOf(const DiskChart& chart, const std::vector<double>& uv) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double lo[2] = {kInfinity, kInfinity}, hi[2] = {-kInfinity, -kInfinity};
  for (std::size_t i = 0; i < chart.boundary.size(); ++i)
    for (std::size_t d = 0; d < 2; ++d) {
      const double x = uv[2 * std::size_t{chart.vertexOfCorner[chart.boundary[i]]} + d];
      lo[d] = std::min(lo[d], x);
      hi[d] = std::max(hi[d], x);
    }
  return std::max(hi[0] - lo[0], hi[1] - lo[1]);
}

std::string note(std::size_t count, double share) {
  char out[140];
  std::snprintf(
      out, sizeof out,
      "the boundary touched itself; %zu of its vertices were pulled back by up to %.1g of "
      "its extent",
      count, share);
  return out;
}

}  // namespace

Attempt movedApart(ChartFlattener& flattener, const Attempt& crossing) {
  const DiskChart& chart = flattener.chart();
  Attempt out = crossing;
  const double cells = flattener.leastDistance(crossing.uv);
  // Condition (9) holds on its limit: moved, edges miss it.
  const bool isDelaunay = !crossing.solution.activeEdge.empty();
  if (isDelaunay || !(cells > 0)) return out;
  const std::vector<double> turned = turnedAlong(boundaryAngles(chart, crossing.solution));
  Outline outline(chart, crossing.uv, flattener.straight());
  Crossings left = crossing.validity.crossings;
  for (int round = 0; round < kRounds && left.count > 0; ++round) {
    if (!outline.moveOn(left, turned, cells)) return out;
    out.uv = outline.moved();
    left = flattener.crossings(out.uv);
  }
  flattener.measure(out);
  if (out.validity.valid()) out.exceeded = exceededBounds(chart, out.uv, out.t);
  out.fallbacks.push_back(note(outline.movedCount(), outline.farthest() / extentOf(chart, out.uv)));
  return out;
}

}  // namespace abflat
