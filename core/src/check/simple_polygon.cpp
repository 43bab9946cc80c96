#include "check/simple_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include "base/stable_order.h"
#include "exact/orientation.h"
#include "exact/segments.h"

namespace abflat {
namespace {

/// Visits the points by x, then y, and keeps the edges that have begun and not yet ended in the
/// order in which a line through the point meets them. Two edges that cross are neighbours in that
/// order before the sweep reaches their crossing.
class CrossingSweep {
 public:
  explicit CrossingSweep(const std::vector<double>& points)
      : points_(points),
        n_(static_cast<std::uint32_t>(points.size() / 2)),
        active_(Below{this}),
        place_(n_, active_.end()) {}

  bool isSimple() {
    const std::vector<std::uint32_t> order =
        stableOrder(n_, [&](std::uint32_t a, std::uint32_t b) { return isBefore(a, b); });
    for (std::uint32_t k = 1; k < n_; ++k)
      if (!isBefore(order[k - 1], order[k])) return false;
    return std::all_of(order.begin(), order.end(), [&](std::uint32_t v) { return pass(v); });
  }

 private:
  struct Below {
    const CrossingSweep* sweep;
    bool operator()(std::uint32_t a, std::uint32_t b) const { return sweep->isBelow(a, b); }
  };
  using Active = std::set<std::uint32_t, Below>;

  const double* at(std::uint32_t v) const { return &points_[2 * std::size_t{v}]; }
  std::uint32_t next(std::uint32_t v) const { return v + 1 == n_ ? 0 : v + 1; }

  bool isBefore(std::uint32_t a, std::uint32_t b) const {
    const double *p = at(a), *q = at(b);
    return p[0] < q[0] || (p[0] == q[0] && p[1] < q[1]);
  }

  /// First end of an edge in sweep order.
  std::uint32_t left(std::uint32_t edge) const {
    return isBefore(edge, next(edge)) ? edge : next(edge);
  }
  std::uint32_t right(std::uint32_t edge) const {
    return isBefore(edge, next(edge)) ? next(edge) : edge;
  }

  bool isBelow(std::uint32_t a, std::uint32_t b) const {
    if (a == b) return false;
    if (left(a) == left(b)) return side(a, right(b)) > 0;
    return isBefore(left(a), left(b)) ? sideOf(a, b) > 0 : sideOf(b, a) < 0;
  }
  /// Side of `edge` on which an edge that begins later lies.
  int sideOf(std::uint32_t edge, std::uint32_t later) const {
    const int begin = side(edge, left(later));
    return begin != 0 ? begin : side(edge, right(later));
  }
  int side(std::uint32_t edge, std::uint32_t v) const {
    return orientation(at(left(edge)), at(right(edge)), at(v));
  }

  bool pass(std::uint32_t v) {
    const std::uint32_t edges[] = {v == 0 ? n_ - 1 : v - 1, v};
    const std::uint32_t others[] = {edges[0], next(v)};
    // Both neighbours on the same side of v, and one edge on the other.
    if (isBefore(others[0], v) == isBefore(others[1], v) &&
        orientation(at(v), at(others[0]), at(others[1])) == 0)
      return false;
    for (const std::uint32_t e : edges)
      if (right(e) == v && !end(e)) return false;
    for (const std::uint32_t e : edges)
      if (left(e) == v && !begin(e)) return false;
    return true;
  }

  bool begin(std::uint32_t edge) {
    const auto [here, isNew] = active_.insert(edge);
    if (!isNew) return false;
    place_[edge] = here;
    return (here == active_.begin() || areApart(*std::prev(here), edge)) &&
           (std::next(here) == active_.end() || areApart(edge, *std::next(here)));
  }

  bool end(std::uint32_t edge) {
    const auto after = active_.erase(place_[edge]);
    return after == active_.begin() || after == active_.end() ||
           areApart(*std::prev(after), *after);
  }

  bool areApart(std::uint32_t a, std::uint32_t b) const {
    // Neighbours meet only at their common corner, which is checked when the sweep passes it.
    if (next(a) == b || next(b) == a) return true;
    return !segmentsMeet(at(a), at(next(a)), at(b), at(next(b)));
  }

  const std::vector<double>& points_;
  std::uint32_t n_;
  Active active_;
  std::vector<Active::iterator> place_;
};

}  // namespace

bool isSimplePolygon(const std::vector<double>& points) {
  const bool isFinite =
      std::all_of(points.begin(), points.end(), [](double x) { return std::isfinite(x); });
  return isFinite && CrossingSweep(points).isSimple();
}

}  // namespace abflat
