#include "verify/chart_gaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>

#include "base/point2.h"
#include "base/stable_order.h"

namespace abflat {
namespace {

constexpr std::uint32_t kSeveral = 0xffffffff;

struct Box {
  Point2 low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};

  void add(const double* p) {
    for (std::size_t d = 0; d < 2; ++d) {
      low[d] = std::min(low[d], p[d]);
      high[d] = std::max(high[d], p[d]);
    }
  }
  double squareFrom(const Box& o) const {
    double out = 0;
    for (std::size_t d = 0; d < 2; ++d) {
      const double apart = std::max({low[d] - o.high[d], o.low[d] - high[d], 0.0});
      out += apart * apart;
    }
    return out;
  }
};

double turnOf(const double* o, const double* a, const double* b) {
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

bool areApart(double a, double b) { return (a > 0 && b < 0) || (a < 0 && b > 0); }

double squareToEdge(const double* p, const double* a, const double* b) {
  const Point2 way = {b[0] - a[0], b[1] - a[1]}, from = {p[0] - a[0], p[1] - a[1]};
  const double square = way[0] * way[0] + way[1] * way[1];
  const double share =
      square > 0 ? std::clamp((way[0] * from[0] + way[1] * from[1]) / square, 0.0, 1.0) : 0;
  const double x = from[0] - share * way[0], y = from[1] - share * way[1];
  return x * x + y * y;
}

/// Between two edges, each of two points.
double squareBetween(const double* e, const double* o) {
  const double *a = e, *b = e + 2, *c = o, *d = o + 2;
  if (areApart(turnOf(a, b, c), turnOf(a, b, d)) && areApart(turnOf(c, d, a), turnOf(c, d, b)))
    return 0;
  return std::min(
      {squareToEdge(a, c, d), squareToEdge(b, c, d), squareToEdge(c, a, b), squareToEdge(d, a, b)});
}

/// A tree of boxes around edges that are near each other.
class EdgeTree {
 public:
  explicit EdgeTree(const OutlineEdges& edges) : edges_(edges), order_(edges.count()) {
    for (std::uint32_t i = 0; i < order_.size(); ++i) order_[i] = i;
    if (!order_.empty()) build(0, order_.size());
  }

  /// Calls `use` with edges of other charts and the square of how far they are away, for all that
  /// may be nearer than the square root of `reach` now says, or as near.
  template <class Reach, class Use>
  void forNear(std::uint32_t edge, const Reach& reach, const Use& use) const {
    Box box;
    for (const std::size_t k : {std::size_t{0}, std::size_t{2}})
      box.add(&edges_.ends[4 * std::size_t{edge} + k]);
    std::vector<std::size_t> open = {0};
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      const Node& node = nodes_[at];
      if (node.chart == edges_.chart[edge] || node.box.squareFrom(box) > reach()) continue;
      if (node.second == 0) {
        for (std::size_t k = node.begin; k < node.end; ++k)
          if (edges_.chart[order_[k]] != edges_.chart[edge])
            use(order_[k], squareBetween(&edges_.ends[4 * std::size_t{edge}],
                                         &edges_.ends[4 * std::size_t{order_[k]}]));
        continue;
      }
      // The nearer one first, which is on top.
      const bool isFirst =
          nodes_[at + 1].box.squareFrom(box) <= nodes_[node.second].box.squareFrom(box);
      open.push_back(isFirst ? node.second : at + 1);
      open.push_back(isFirst ? at + 1 : node.second);
    }
  }

 private:
  struct Node {
    Box box;
    std::uint32_t chart = kSeveral;  ///< that all edges belong to
    std::size_t begin = 0, end = 0;  ///< in the order
    std::size_t second = 0;          ///< the other half; the first one follows; 0: not divided
  };

  double middle(std::uint32_t edge, std::size_t d) const {
    return edges_.ends[4 * std::size_t{edge} + d] / 2 +
           edges_.ends[4 * std::size_t{edge} + 2 + d] / 2;
  }

  std::size_t build(std::size_t begin, std::size_t end) {
    constexpr std::size_t kFew = 8;
    const std::size_t at = nodes_.size();
    nodes_.emplace_back();
    Node node;
    node.begin = begin;
    node.end = end;
    node.chart = edges_.chart[order_[begin]];
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t e = 4 * std::size_t{order_[k]};
      node.box.add(&edges_.ends[e]);
      node.box.add(&edges_.ends[e + 2]);
      if (edges_.chart[order_[k]] != node.chart) node.chart = kSeveral;
    }
    if (end - begin > kFew) {
      const std::size_t d =
          node.box.high[0] - node.box.low[0] >= node.box.high[1] - node.box.low[1] ? 0 : 1;
      const auto half = static_cast<std::ptrdiff_t>(begin + (end - begin) / 2);
      std::nth_element(order_.begin() + static_cast<std::ptrdiff_t>(begin), order_.begin() + half,
                       order_.begin() + static_cast<std::ptrdiff_t>(end),
                       [&](std::uint32_t a, std::uint32_t b) {
                         return std::make_tuple(middle(a, d), a) < std::make_tuple(middle(b, d), b);
                       });
      build(begin, static_cast<std::size_t>(half));
      node.second = build(static_cast<std::size_t>(half), end);
    }
    nodes_[at] = node;
    return at;
  }

  const OutlineEdges& edges_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

ChartGap gapOf(const OutlineEdges& edges, std::uint32_t i, std::uint32_t k, double square) {
  if (edges.chart[k] < edges.chart[i]) std::swap(i, k);
  return {{edges.chart[i], edges.chart[k]}, {i, k}, std::sqrt(square)};
}

/// Ties go to smaller numbers, so that the order of looking does not matter.
bool isLess(const ChartGap& a, const ChartGap& b) {
  return std::tie(a.distance, a.charts, a.edges) < std::tie(b.distance, b.charts, b.edges);
}

}  // namespace

std::optional<ChartGap> leastGap(const OutlineEdges& edges) {
  const EdgeTree tree(edges);
  std::optional<ChartGap> out;
  double least = HUGE_VAL;
  for (std::uint32_t i = 0; i < edges.count(); ++i)
    tree.forNear(
        i, [&] { return least; },
        [&](std::uint32_t k, double square) {
          if (square > least) return;
          const ChartGap gap = gapOf(edges, i, k, square);
          if (!out || square < least || isLess(gap, *out)) out = gap;
          least = square;
        });
  return out;
}

std::vector<ChartGap> gapsBelow(const OutlineEdges& edges, double reach) {
  const EdgeTree tree(edges);
  const double most = reach * reach;
  std::map<std::array<std::uint32_t, 2>, ChartGap> found;
  for (std::uint32_t i = 0; i < edges.count(); ++i)
    tree.forNear(
        i, [&] { return most; },
        [&](std::uint32_t k, double square) {
          if (k < i || !(square < most)) return;
          const ChartGap gap = gapOf(edges, i, k, square);
          const auto [at, isNew] = found.emplace(gap.charts, gap);
          if (!isNew && isLess(gap, at->second)) at->second = gap;
        });
  std::vector<ChartGap> out;
  out.reserve(found.size());
  for (const auto& [charts, gap] : found) out.push_back(gap);
  return out;
}

}  // namespace abflat
