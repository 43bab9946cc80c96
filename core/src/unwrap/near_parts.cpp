#include "unwrap/near_parts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/point2.h"
#include "mesh/triangle_geometry.h"
#include "refine/near_pairs.h"

namespace abflat {
namespace {

/// Times the padding.
constexpr double kFarInSpace = 4, kFarAlong = 16;

double cross(const Point2& a, const Point2& b) { return a[0] * b[1] - a[1] * b[0]; }
Point2 minus(const Point2& a, const Point2& b) { return {a[0] - b[0], a[1] - b[1]}; }
double lengthOf(const Point2& a) { return norm(a[0], a[1]); }

/// At least the distance of the points farthest apart in space.
double extentOf(const PlacedOutline& outline) {
  Vec3 low, high;
  low.fill(HUGE_VAL);
  high.fill(-HUGE_VAL);
  for (std::size_t i = 0; i < outline.positions.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], outline.positions[i]);
    high[i % 3] = std::max(high[i % 3], outline.positions[i]);
  }
  return norm(Vec3{high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

double lengthOfLoop(const std::vector<double>& uv) {
  double out = 0;
  const std::size_t count = uv.size() / 2;
  for (std::size_t i = 0; i < count; ++i)
    out += lengthOf(minus(pointAt(uv, i + 1 < count ? i + 1 : 0), pointAt(uv, i)));
  return out;
}

/// Whether there is room for two parts that are far from each other, in space and along the
/// outline.
bool hasFarParts(const PlacedOutline& outline, double padding) {
  constexpr std::size_t kFewest = 4;  // each point of a triangle is beside all others
  return outline.uv.size() / 2 >= kFewest && lengthOfLoop(outline.uv) > 2 * kFarAlong * padding &&
         extentOf(outline) > kFarInSpace * padding;
}

/// The outline in steps of similar length: points that hardly differ from the one before are left
/// out, since each would be near very many, and long edges are divided, since they may be near
/// another one somewhere between their ends.
struct Steps {
  PlacedOutline at;
  std::vector<std::uint32_t> edge;    ///< of the outline, that begins at a point or contains it
  std::vector<std::uint8_t> isPoint;  ///< of the outline
  std::vector<double> since;          ///< length of the outline before each point, and of all

  std::uint32_t count() const { return static_cast<std::uint32_t>(edge.size()); }
  std::uint32_t after(std::uint32_t i) const { return i + 1 == count() ? 0 : i + 1; }
  std::uint32_t before(std::uint32_t i) const { return (i == 0 ? count() : i) - 1; }
  Point2 uv(std::uint32_t i) const { return pointAt(at.uv, i); }
  Point2 along(std::uint32_t i) const { return minus(uv(after(i)), uv(i)); }
  /// A share of the way to the next one.
  Vec3 position(std::uint32_t i, double share) const {
    const double *a = &at.positions[3 * std::size_t{i}],
                 *b = &at.positions[3 * std::size_t{after(i)}];
    return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]),
            a[2] + share * (b[2] - a[2])};
  }
  /// The shorter way along the outline.
  double lengthBetween(std::uint32_t i, std::uint32_t k, double share) const {
    const double way = std::abs(since[k] + share * (since[k + 1] - since[k]) - since[i]);
    return std::min(way, since.back() - way);
  }
};

/// Goes from a point of the outline to the next one that is kept.
void addSteps(const PlacedOutline& outline, std::uint32_t from, std::uint32_t to, double most,
              Steps& out) {
  const Point2 a = pointAt(outline.uv, from), way = minus(pointAt(outline.uv, to), a);
  const double *p = &outline.positions[3 * std::size_t{from}],
               *q = &outline.positions[3 * std::size_t{to}];
  const auto pieces = static_cast<std::uint32_t>(std::max(std::ceil(lengthOf(way) / most), 1.0));
  for (std::uint32_t k = 0; k < pieces; ++k) {
    const double share = static_cast<double>(k) / pieces;
    for (std::size_t d = 0; d < 2; ++d) out.at.uv.push_back(a[d] + share * way[d]);
    for (std::size_t d = 0; d < 3; ++d) out.at.positions.push_back(p[d] + share * (q[d] - p[d]));
    out.edge.push_back(from);
    out.isPoint.push_back(k == 0);
    out.since.push_back(out.since.back() + lengthOf(way) / pieces);
  }
}

Steps stepsOf(const PlacedOutline& outline, double padding) {
  constexpr double kLeast = 1.0 / 32, kMost = 2;  // times the padding
  Steps out;
  out.since.push_back(0);
  std::uint32_t from = 0;
  for (std::uint32_t i = 1; i < outline.uv.size() / 2; ++i) {
    const Point2 way = minus(pointAt(outline.uv, i), pointAt(outline.uv, from));
    if (lengthOf(way) < kLeast * padding) continue;
    addSteps(outline, from, i, kMost * padding, out);
    from = i;
  }
  addSteps(outline, from, 0, kMost * padding, out);
  return out;
}

/// Where an outline is so dense that very many points are near each other, some of them are enough.
std::vector<std::uint8_t> pointsToAsk(const std::vector<double>& uv, double padding) {
  constexpr std::size_t kMost = 64;  // per square of one padding: all but in such places
  std::map<std::array<double, 2>, std::vector<std::uint32_t>> squares;
  for (std::uint32_t i = 0; i < uv.size() / 2; ++i)
    squares[{std::floor(uv[2 * i] / padding), std::floor(uv[2 * i + 1] / padding)}].push_back(i);
  std::vector<std::uint8_t> out(uv.size() / 2, 0);
  for (const auto& [square, points] : squares) {
    const std::size_t step = (points.size() + kMost - 1) / kMost;
    for (std::size_t k = 0; k < points.size(); k += step) out[points[k]] = 1;
  }
  return out;
}

class Search {
 public:
  Search(const PlacedOutline& outline, double padding)
      : steps_(stepsOf(outline, padding)),
        padding_(padding),
        last_(static_cast<std::uint32_t>(outline.uv.size() / 2 - 1)) {}

  NearParts run() {
    out_.gap = padding_;
    forNearPairs(steps_.at.uv, padding_, pointsToAsk(steps_.at.uv, padding_),
                 [this](const NearPair& pair) { look(pair.point, pair.edge); });
    dropRepeated();
    return std::move(out_);
  }

 private:
  /// Whether a way into that direction begins outside of the chart.
  bool isOutside(std::uint32_t point, const Point2& way) const {
    const Point2 in = steps_.along(steps_.before(point)), out = steps_.along(point);
    const bool isLeftOfIn = cross(in, way) > 0, isLeftOfOut = cross(out, way) > 0;
    return cross(in, out) > 0 ? !(isLeftOfIn && isLeftOfOut) : !(isLeftOfIn || isLeftOfOut);
  }

  bool isFar(std::uint32_t point, std::uint32_t step, double share) const {
    const Vec3 a = steps_.position(point, 0), b = steps_.position(step, share);
    return norm(Vec3{b[0] - a[0], b[1] - a[1], b[2] - a[2]}) > kFarInSpace * padding_ &&
           steps_.lengthBetween(point, step, share) > kFarAlong * padding_;
  }

  void look(std::uint32_t point, std::uint32_t step) {
    const Point2 e = steps_.along(step), toPoint = minus(steps_.uv(point), steps_.uv(step));
    const double share =
        std::clamp((e[0] * toPoint[0] + e[1] * toPoint[1]) / (e[0] * e[0] + e[1] * e[1]), 0.0, 1.0);
    const Point2 way = {toPoint[0] - share * e[0], toPoint[1] - share * e[1]};
    const double gap = lengthOf(way);
    if (!(gap < padding_) || !isFar(point, step, share)) return;
    if (!isOutside(point, {-way[0], -way[1]})) return;
    const bool isAtEnd = share == 0 || share == 1;
    const std::uint32_t end = share == 0 ? step : steps_.after(step);
    if (isAtEnd ? !isOutside(end, way) : cross(e, way) > 0) return;
    if (gap < out_.gap) {
      out_.gap = gap;
      out_.point = steps_.edge[point];
    }
    for (const std::uint32_t own : edgesAt(point)) {
      add(own, steps_.edge[isAtEnd ? end : step]);
      if (isAtEnd) add(own, edgesAt(end)[0]);
    }
  }

  /// A cut that ends at a point of the outline leaves it at both sides.
  std::array<std::uint32_t, 2> edgesAt(std::uint32_t i) const {
    const std::uint32_t edge = steps_.edge[i];
    return {steps_.isPoint[i] ? (edge == 0 ? last_ : edge - 1) : edge, edge};
  }

  void add(std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    out_.edges.push_back({std::min(a, b), std::max(a, b)});
    if (out_.edges.size() < most_) return;
    dropRepeated();
    most_ = std::max(kFew, 2 * out_.edges.size());
  }

  void dropRepeated() {
    std::sort(out_.edges.begin(), out_.edges.end());
    out_.edges.erase(std::unique(out_.edges.begin(), out_.edges.end()), out_.edges.end());
  }

  static constexpr std::size_t kFew = std::size_t{1} << 16;

  const Steps steps_;
  const double padding_;
  const std::uint32_t last_;  ///< edge of the outline
  std::size_t most_ = kFew;   ///< pairs of edges, before repeated ones are dropped
  NearParts out_;
};

}  // namespace

NearParts findNearParts(const PlacedOutline& outline, double padding) {
  const bool isAny = padding > 0 && hasFarParts(outline, padding);
  return isAny ? Search(outline, padding).run() : NearParts();
}

}  // namespace abflat
