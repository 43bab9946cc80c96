#include "boundary/contacts.h"

#include <algorithm>
#include <cmath>

#include "base/point2.h"
#include "base/portable_math.h"

namespace abflat {
namespace {

/// Unit vector to the right of the edge from a to b, outside of the chart.
Point2 rightOf(const Point2& a, const Point2& b) {
  const double x = b[0] - a[0], y = b[1] - a[1];
  const double length = portable::hypot(x, y);
  return length > 0 ? Point2{y / length, -x / length} : Point2{0, 0};
}

/// The direction in which a corner moves as its edges, with the normals a and b, move outwards by
/// 1. A spike moves along its axis. The end of a slit, whose sides have opposite normals, stays.
Point2 outwards(const Point2& a, const Point2& b) {
  const Point2 half = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
  const double length = portable::hypot(half[0], half[1]);
  const bool isConvex = a[0] * b[1] - a[1] * b[0] > 0;
  if (!isConvex || !(length > 0)) return half;
  return {half[0] / length, half[1] / length};
}

/// Places of the boundary without those closer than a few cells to the one before, so that places
/// near each other belong to different parts of the boundary.
std::vector<BoundaryIndex> placesApart(const DiskChart& chart, const std::vector<double>& uv,
                                       double cell) {
  constexpr double kFewCells = 2;
  const auto isNear = [&](BoundaryIndex i, BoundaryIndex j) {
    const Point2 p = pointAt(uv, chart.boundaryVertex(i)), q = pointAt(uv, chart.boundaryVertex(j));
    const double x = (p[0] - q[0]) / cell, y = (p[1] - q[1]) / cell;
    return x * x + y * y < kFewCells * kFewCells;
  };
  std::vector<BoundaryIndex> out;
  for (const BoundaryIndex i : chart.boundary.ids())
    if (i == 0 || !isNear(i, out.back())) out.push_back(i);
  while (out.size() > 1 && isNear(out.back(), out.front())) out.pop_back();
  return out;
}

}  // namespace

double contactCell(const DiskChart& chart, const std::vector<double>& uv) {
  double size = 0;
  const Point2 first = pointAt(uv, chart.boundaryVertex(BoundaryIndex(0)));
  for (const BoundaryIndex i : chart.boundary.ids()) {
    const Point2 p = pointAt(uv, chart.boundaryVertex(i));
    for (std::size_t d = 0; d < 2; ++d) size = std::max(size, std::abs(p[d] - first[d]));
  }
  return size > 0 && std::isfinite(size) ? std::ldexp(1.0, std::ilogb(size) - 20) : 0;
}

Crossings findContacts(const DiskChart& chart, const std::vector<double>& uv) {
  const double cell = contactCell(chart, uv);
  if (!(cell > 0)) return {};
  const std::vector<BoundaryIndex> places = placesApart(chart, uv, cell);
  const std::size_t n = places.size();
  const auto at = [&](std::size_t k) { return pointAt(uv, chart.boundaryVertex(places[k % n])); };
  std::vector<double> wider;
  wider.reserve(2 * n);
  for (std::size_t k = 0; k < n; ++k) {
    const Point2 here = at(k);
    const Point2 by = outwards(rightOf(at(k + n - 1), here), rightOf(here, at(k + 1)));
    for (std::size_t d = 0; d < 2; ++d) wider.push_back(here[d] + by[d] * cell / 2);
  }
  Crossings out = findCrossings(wider);
  for (auto& pair : out.first)
    for (std::uint32_t& edge : pair) edge = places[edge];
  return out;
}

}  // namespace abflat
