#include "check/covered_once.h"

#include <iterator>
#include <set>

#include "base/stable_order.h"
#include "exact/segments.h"

namespace abflat {
namespace {

using Pair = std::array<std::uint32_t, 2>;

/// A line that sweeps the plane from left to right and meets points of one column from the bottom
/// up, as if the plane were slightly sheared (Shamos and Hoey 1976). An edge has the number of its
/// first point.
class CoverSweep {
 public:
  explicit CoverSweep(const Curves& curves) : points_(curves.points), active_(Below{this}) {
    const std::size_t n = points_.size() / 2;
    next_.resize(n);
    previous_.resize(n);
    std::uint32_t begin = 0;
    for (const std::uint32_t end : curves.ends) {
      for (std::uint32_t p = begin; p < end; ++p) {
        next_[p] = p + 1 < end ? p + 1 : begin;
        previous_[next_[p]] = p;
      }
      begin = end;
    }
  }

  std::optional<Pair> run() {
    const std::vector<std::uint32_t> order = stableOrder(
        next_.size(), [this](std::uint32_t a, std::uint32_t b) { return isBefore(a, b); });
    where_.resize(order.size());
    for (std::size_t i = 0; i < order.size() && !wrong_; ++i) {
      if (i > 0 && !isBefore(order[i - 1], order[i])) return Pair{order[i - 1], order[i]};
      pass(order[i]);
    }
    return wrong_;
  }

 private:
  struct Active {
    mutable std::uint32_t edge;  ///< changing to the curve's next edge keeps the order
  };
  struct Point {
    std::uint32_t number;
  };
  struct Below {
    using is_transparent = void;
    const CoverSweep* sweep;
    bool operator()(const Active& a, const Active& b) const {
      return sweep->isBelow(a.edge, b.edge);
    }
    bool operator()(const Active& a, Point p) const { return sweep->sideOf(a.edge, p.number) > 0; }
    bool operator()(Point p, const Active& a) const { return sweep->sideOf(a.edge, p.number) < 0; }
  };
  using Place = std::set<Active, Below>::iterator;

  const double* point(std::uint32_t p) const { return &points_[2 * std::size_t{p}]; }
  bool isBefore(std::uint32_t p, std::uint32_t q) const {
    const double *a = point(p), *b = point(q);
    return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1];
  }
  bool goesRight(std::uint32_t edge) const { return isBefore(edge, next_[edge]); }
  std::uint32_t left(std::uint32_t edge) const { return goesRight(edge) ? edge : next_[edge]; }
  std::uint32_t right(std::uint32_t edge) const { return goesRight(edge) ? next_[edge] : edge; }

  /// 1 if the point is above the edge's line.
  int sideOf(std::uint32_t edge, std::uint32_t p) const {
    return orientation(point(left(edge)), point(right(edge)), point(p));
  }

  /// Both edges must be under the sweep line.
  bool isBelow(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t p = left(a), q = left(b);
    if (p == q) return sideOf(a, right(b)) > 0;
    return isBefore(p, q) ? sideOf(a, q) > 0 : sideOf(b, p) < 0;
  }

  void pass(std::uint32_t p) {
    const std::uint32_t in = previous_[p], out = p;
    const bool isInNew = isBefore(p, in), isOutNew = isBefore(p, next_[p]);
    if (isInNew && isOutNew)
      begin(p, in, out);
    else if (!isInNew && !isOutNew)
      end(in, out);
    else
      goOn(isInNew ? out : in, isInNew ? in : out);
  }

  /// Two edges begin here: the edges below tell what they have to bound.
  void begin(std::uint32_t p, std::uint32_t in, std::uint32_t out) {
    const Place above = active_.lower_bound(Point{p});
    if (above != active_.end() && sideOf(above->edge, p) == 0) return fail(p, above->edge);
    const int turn = orientation(point(p), point(in), point(next_[p]));
    if (turn == 0) return fail(in, out);
    const std::uint32_t lower = turn > 0 ? in : out, upper = turn > 0 ? out : in;
    const bool hasBelow = above != active_.begin();
    const bool isCovered = hasBelow && goesRight(std::prev(above)->edge);
    if (goesRight(lower) == isCovered)
      return fail(lower, hasBelow ? std::prev(above)->edge : lower);
    where_[upper] = active_.emplace_hint(above, Active{upper});
    where_[lower] = active_.emplace_hint(where_[upper], Active{lower});
    if (hasBelow) compare(std::prev(where_[lower]));
    compare(where_[upper]);
  }

  void end(std::uint32_t a, std::uint32_t b) {
    Place low = where_[a], high = where_[b];
    if (std::next(low) != high) std::swap(low, high);
    const Place between = std::next(low);
    if (between != high) return fail(a, between == active_.end() ? b : between->edge);
    const Place above = active_.erase(low, std::next(high));
    if (above != active_.begin()) compare(std::prev(above));
  }

  void goOn(std::uint32_t from, std::uint32_t to) {
    const Place at = where_[from];
    at->edge = to;
    where_[to] = at;
    if (at != active_.begin()) compare(std::prev(at));
    compare(at);
  }

  /// Compares an edge with the one above it.
  void compare(Place at) {
    const Place above = std::next(at);
    if (above != active_.end() && meet(at->edge, above->edge)) fail(at->edge, above->edge);
  }

  bool meet(std::uint32_t a, std::uint32_t b) const {
    // Neighbours end at their common point: they only meet if one lies on the other.
    if (next_[a] == b) return orientation(point(a), point(b), point(next_[b])) == 0;
    if (next_[b] == a) return orientation(point(b), point(a), point(next_[a])) == 0;
    return segmentsMeet(point(a), point(next_[a]), point(b), point(next_[b]));
  }

  void fail(std::uint32_t a, std::uint32_t b) {
    if (!wrong_) wrong_ = Pair{a, b};
  }

  const std::vector<double>& points_;
  std::vector<std::uint32_t> next_, previous_;
  std::set<Active, Below> active_;  ///< from the bottom up
  std::vector<Place> where_;        ///< position of each active edge
  std::optional<Pair> wrong_;
};

}  // namespace

std::optional<std::array<std::uint32_t, 2>> findWrongCover(const Curves& curves) {
  return CoverSweep(curves).run();
}

}  // namespace abflat
