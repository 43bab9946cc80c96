#pragma once

#include <cstdint>
#include <vector>

#include "base/point2.h"

namespace abflat {

/// Points in the plane, some of which are active, in a tree of boxes. Tells whether an active point
/// lies in a triangle without looking at points far from it.
class PointTree {
 public:
  /// Initially no point is active. `points` must outlive the tree.
  explicit PointTree(const std::vector<Point2>& points);

  void add(std::uint32_t point) { change(point, 1); }
  void remove(std::uint32_t point) { change(point, -1); }

  /// Whether an active point is in the triangle or on its rim, but not at one of its corners. Sides
  /// are decided by turnOf, so that rounding is the same as elsewhere.
  bool hasIn(const Point2& a, const Point2& b, const Point2& c) const;

 private:
  struct Node {
    Point2 low, high;          ///< of all its points
    std::uint32_t begin, end;  ///< in order_
    std::uint32_t counting = 0;
  };

  void build(std::uint32_t node);
  void change(std::uint32_t point, int by);
  bool isLeaf(std::uint32_t node) const { return 2 * node + 1 >= nodes_.size(); }

  const std::vector<Point2>& points_;
  std::vector<Node> nodes_;                   ///< children of i are 2i + 1 and 2i + 2
  std::vector<std::uint32_t> order_, place_;  ///< place_: index into order_ per point
  std::vector<std::uint8_t> counts_;
};

}  // namespace abflat
