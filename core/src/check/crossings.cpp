#include "check/crossings.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "check/simple_polygon.h"
#include "exact/orientation.h"
#include "exact/segments.h"

namespace abflat {
namespace {

struct EdgeBox {
  double lo[2], hi[2];
};

bool disjoint(const EdgeBox& a, const EdgeBox& b) {
  return a.lo[0] > b.hi[0] || b.lo[0] > a.hi[0] || a.lo[1] > b.hi[1] || b.lo[1] > a.hi[1];
}

/// Spreads the bits of x to the even positions.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 16) & 0x0000ffff0000ffff;
  x = (x | x << 8) & 0x00ff00ff00ff00ff;
  x = (x | x << 4) & 0x0f0f0f0f0f0f0f0f;
  x = (x | x << 2) & 0x3333333333333333;
  return (x | x << 1) & 0x5555555555555555;
}

/// Edges of a closed polygon in the order of a space-filling curve (Morton's); ties keep their
/// order.
std::vector<std::uint32_t> spatialOrder(const std::vector<double>& points) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double lo[2] = {kInfinity, kInfinity}, hi[2] = {-kInfinity, -kInfinity};
  for (std::size_t i = 0; i < points.size(); ++i) {
    lo[i % 2] = std::min(lo[i % 2], points[i]);
    hi[i % 2] = std::max(hi[i % 2], points[i]);
  }
  constexpr double kCells = 4294967295.0;
  const double size = std::max(hi[0] - lo[0], hi[1] - lo[1]);
  const auto cell = [&](std::size_t point, std::size_t d) -> std::uint64_t {
    const double x = (points[2 * point + d] - lo[d]) / size * kCells;
    return x > 0 ? static_cast<std::uint64_t>(std::min(x, kCells)) : 0;
  };
  const auto n = static_cast<std::uint32_t>(points.size() / 2);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(n);
  for (std::uint32_t i = 0; i < n; ++i) keys[i] = {spread(cell(i, 0)) | spread(cell(i, 1)) << 1, i};
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(n);
  for (std::uint32_t k = 0; k < n; ++k) order[k] = keys[k].second;
  return order;
}

/// Tests pairs of edges of a closed polygon, and counts those that meet.
class PairTest {
 public:
  PairTest(const std::vector<double>& points, std::size_t most)
      : points_(points), most_(most), n_(static_cast<std::uint32_t>(points.size() / 2)) {}

  std::uint32_t size() const { return n_; }
  bool isFull() const { return found_.count == most_; }
  void clear() { found_ = {}; }
  /// What was found, in order.
  Crossings take() {
    std::sort(found_.first.begin(), found_.first.end());
    return std::move(found_);
  }

  EdgeBox boxOf(std::uint32_t edge) const {
    const double *from = point(edge), *to = point(edge + 1);
    EdgeBox box;
    for (int d = 0; d < 2; ++d) {
      box.lo[d] = std::min(from[d], to[d]);
      box.hi[d] = std::max(from[d], to[d]);
    }
    return box;
  }

  /// With i < j.
  void test(std::uint32_t i, std::uint32_t j) {
    bool meet;
    if (j == i + 1)
      meet = foldsBack(i);
    else if (i == 0 && j == n_ - 1)
      meet = foldsBack(j);
    else
      meet = segmentsMeet(point(i), point(i + 1), point(j), point(j + 1));
    if (!meet) return;
    ++found_.count;
    if (found_.first.size() < kKept) found_.first.push_back({i, j});
  }

 private:
  const double* point(std::uint32_t i) const { return &points_[2 * (i == n_ ? 0 : i)]; }

  /// Whether edge i + 1 folds back onto edge i.
  bool foldsBack(std::uint32_t i) const {
    const double *a = point(i), *b = point(i + 1), *c = point(i + 1 == n_ ? 1 : i + 2);
    if (orientation(a, b, c) != 0) return false;
    return isBetween(a, b, c) || isBetween(b, c, a);
  }

  static constexpr std::size_t kKept = 4096;

  const std::vector<double>& points_;
  const std::size_t most_;
  const std::uint32_t n_;
  Crossings found_;
};

/// The most edges of which all pairs are tested, which a tree would take longer to sort.
constexpr std::uint32_t kFewEdges = 32;

Crossings amongFew(const std::vector<double>& points, std::size_t most) {
  PairTest pairs(points, most);
  std::array<EdgeBox, kFewEdges> boxes;
  for (std::uint32_t j = 0; j < pairs.size(); ++j) {
    boxes[j] = pairs.boxOf(j);
    for (std::uint32_t i = 0; i < j && !pairs.isFull(); ++i)
      if (!disjoint(boxes[i], boxes[j])) pairs.test(i, j);
  }
  return pairs.take();
}

/// Bounding boxes of runs of edges in spatial order, so that boxes overlap little however coiled
/// the curve is.
class EdgeTree {
 public:
  EdgeTree(const std::vector<double>& points, std::size_t most)
      : points_(points), order_(spatialOrder(points)), pairs_(points, most), n_(pairs_.size()) {
    while (leaves_ < n_) leaves_ *= 2;
    boxes_.resize(2 * static_cast<std::size_t>(leaves_));
    build(1, 0, leaves_);
  }

  /// Whether boxes separate the edges so poorly, as with long ones side by side, that a sweep is
  /// better.
  bool isSweepBetter() {
    constexpr std::size_t kManyPairs = 64;
    allowed_ = kManyPairs * n_;
    within(1, 0, leaves_);
    const bool isBetter = allowed_ == 0 && !pairs_.isFull();
    allowed_ = std::numeric_limits<std::size_t>::max();
    if (isBetter) pairs_.clear();
    return isBetter;
  }

  Crossings run() {
    if (isSweepBetter()) {
      if (isSimplePolygon(points_)) return {};
      within(1, 0, leaves_);
    }
    return pairs_.take();
  }

 private:
  void build(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
    if (begin >= n_) return;
    EdgeBox& box = boxes_[node];
    if (end - begin == 1) {
      box = pairs_.boxOf(order_[begin]);
      return;
    }
    const std::uint32_t middle = (begin + end) / 2;
    build(2 * node, begin, middle);
    build(2 * node + 1, middle, end);
    box = boxes_[2 * node];
    if (middle >= n_) return;
    for (int d = 0; d < 2; ++d) {
      box.lo[d] = std::min(box.lo[d], boxes_[2 * node + 1].lo[d]);
      box.hi[d] = std::max(box.hi[d], boxes_[2 * node + 1].hi[d]);
    }
  }

  /// Pairs inside one run of edges.
  void within(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
    if (begin >= n_ || end - begin == 1) return;
    const std::uint32_t middle = (begin + end) / 2;
    within(2 * node, begin, middle);
    within(2 * node + 1, middle, end);
    across(2 * node, begin, 2 * node + 1, middle, middle - begin);
  }

  /// Pairs between two runs of `size` edges each.
  void across(std::uint32_t nodeA, std::uint32_t a, std::uint32_t nodeB, std::uint32_t b,
              std::uint32_t size) {
    if (allowed_ == 0 || pairs_.isFull()) return;
    --allowed_;
    if (a >= n_ || b >= n_ || disjoint(boxes_[nodeA], boxes_[nodeB])) return;
    if (size == 1)
      return pairs_.test(std::min(order_[a], order_[b]), std::max(order_[a], order_[b]));
    const std::uint32_t half = size / 2;
    for (std::uint32_t i = 0; i < 2; ++i)
      for (std::uint32_t j = 0; j < 2; ++j)
        across(2 * nodeA + i, a + i * half, 2 * nodeB + j, b + j * half, half);
  }

  const std::vector<double>& points_;
  std::vector<std::uint32_t> order_;
  PairTest pairs_;
  const std::uint32_t n_;
  std::uint32_t leaves_ = 1;
  std::size_t allowed_ = 0;  ///< pairs of boxes that may still be tested
  std::vector<EdgeBox> boxes_;
};

}  // namespace

Crossings findCrossings(const std::vector<double>& points, std::size_t most) {
  // All edges of a triangle are neighbours; with positive area it is simple.
  if (points.size() < 8) return {};
  if (points.size() <= 2 * kFewEdges) return amongFew(points, most);
  return EdgeTree(points, most).run();
}

}  // namespace abflat
