#pragma once

#include <cstdint>
#include <vector>

#include "base/point2.h"
#include "exact/orientation.h"

namespace abflat {

/// An edge at a corner, from the previous corner or to the next one, as seen from the corner's
/// place.
struct Arm {
  std::uint32_t corner;
  bool isOut;
  Point2 end;
  std::uint32_t turn = 0;  ///< number of arms of its kind before it in the same direction
};

/// Sorts clockwise, starting from straight left.
struct Clockwise {
  Point2 at;

  bool isUpper(const Point2& p) const { return p[1] != at[1] ? p[1] > at[1] : p[0] < at[0]; }
  int compare(const Point2& p, const Point2& q) const {
    if (isUpper(p) != isUpper(q)) return isUpper(p) ? -1 : 1;
    return orientation(at.data(), p.data(), q.data());
  }
  bool operator()(const Arm& a, const Arm& b) const {
    const int side = compare(a.end, b.end);
    if (side != 0) return side < 0;
    if (a.turn != b.turn) return a.turn < b.turn;
    return a.isOut != b.isOut ? a.isOut : a.corner < b.corner;
  }
};

/// Arms at the corners of a polygon that are at one place, clockwise. The two sides of a bridge: it
/// leaves before it comes back, and so do all bridges along it. None if a neighbour coincides with
/// the place.
std::vector<Arm> armsAround(const std::vector<Point2>& points, const std::uint32_t* begin,
                            const std::uint32_t* end);

}  // namespace abflat
