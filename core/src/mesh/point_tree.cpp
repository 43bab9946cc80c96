#include "mesh/point_tree.h"

#include <algorithm>
#include <numeric>

#include "mesh/clip_ears.h"

namespace abflat {
namespace {

constexpr std::size_t kMostInLeaf = 8;

/// The greatest turnOf(a, b, p) over a box. turnOf is monotonic in each coordinate of p, even when
/// it is rounded.
double mostTurn(const Point2& a, const Point2& b, const Point2& low, const Point2& high) {
  return turnOf(a, b, {b[1] - a[1] < 0 ? high[0] : low[0], b[0] - a[0] < 0 ? low[1] : high[1]});
}

}  // namespace

PointTree::PointTree(const std::vector<Point2>& points)
    : points_(points), order_(points.size()), place_(points.size()), counts_(points.size(), 0) {
  std::iota(order_.begin(), order_.end(), 0u);
  std::size_t leaves = 1;
  while (leaves * kMostInLeaf < points.size()) leaves *= 2;
  nodes_.resize(2 * leaves - 1);
  nodes_[0].begin = 0;
  nodes_[0].end = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) build(i);
  for (std::uint32_t i = 0; i < order_.size(); ++i) place_[order_[i]] = i;
}

/// Splits a node's points in half across the longer side of their box.
void PointTree::build(std::uint32_t i) {
  Node& node = nodes_[i];
  node.low = node.high = node.begin < node.end ? points_[order_[node.begin]] : Point2{};
  for (std::uint32_t k = node.begin; k < node.end; ++k)
    for (std::size_t d = 0; d < 2; ++d) {
      node.low[d] = std::min(node.low[d], points_[order_[k]][d]);
      node.high[d] = std::max(node.high[d], points_[order_[k]][d]);
    }
  if (isLeaf(i)) return;
  const std::size_t axis = node.high[1] - node.low[1] > node.high[0] - node.low[0];
  const std::uint32_t middle = node.begin + (node.end - node.begin) / 2;
  std::nth_element(
      order_.begin() + node.begin, order_.begin() + middle, order_.begin() + node.end,
      [&](std::uint32_t p, std::uint32_t q) {
        return points_[p][axis] != points_[q][axis] ? points_[p][axis] < points_[q][axis] : p < q;
      });
  nodes_[2 * i + 1].begin = node.begin;
  nodes_[2 * i + 1].end = nodes_[2 * i + 2].begin = middle;
  nodes_[2 * i + 2].end = node.end;
}

void PointTree::change(std::uint32_t point, int by) {
  counts_[point] = by > 0;
  const std::uint32_t at = place_[point];
  for (std::uint32_t i = 0;;) {
    nodes_[i].counting += static_cast<std::uint32_t>(by);
    if (isLeaf(i)) return;
    i = 2 * i + (at < nodes_[2 * i + 1].end ? 1 : 2);
  }
}

bool PointTree::hasIn(const Point2& a, const Point2& b, const Point2& c) const {
  const auto isCorner = [&](const Point2& p) { return p == a || p == b || p == c; };
  std::array<std::uint32_t, 64> stack;
  std::size_t size = 1;
  stack[0] = 0;
  while (size > 0) {
    const std::uint32_t i = stack[--size];
    const Node& node = nodes_[i];
    if (node.counting == 0 || (node.low == node.high && isCorner(node.low)) ||
        mostTurn(a, b, node.low, node.high) < 0 || mostTurn(b, c, node.low, node.high) < 0 ||
        mostTurn(c, a, node.low, node.high) < 0)
      continue;
    if (!isLeaf(i)) {
      stack[size++] = 2 * i + 2;
      stack[size++] = 2 * i + 1;
      continue;
    }
    for (std::uint32_t k = node.begin; k < node.end; ++k) {
      const Point2& p = points_[order_[k]];
      if (counts_[order_[k]] && !isCorner(p) && turnOf(a, b, p) >= 0 && turnOf(b, c, p) >= 0 &&
          turnOf(c, a, p) >= 0)
        return true;
    }
  }
  return false;
}

}  // namespace abflat
