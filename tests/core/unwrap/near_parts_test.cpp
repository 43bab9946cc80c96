#include "unwrap/near_parts.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "catch.h"

using namespace abflat;

namespace {

using Point = std::array<double, 2>;

/// As it lies in the plane, and where `inSpace` puts it.
PlacedOutline placed(const std::vector<Point>& points,
                     const std::function<std::array<double, 3>(Point)>& inSpace) {
  PlacedOutline out;
  for (const Point& p : points) {
    out.uv.insert(out.uv.end(), p.begin(), p.end());
    for (const double x : inSpace(p)) out.positions.push_back(x);
  }
  return out;
}

std::array<double, 3> flat(Point p) { return {p[0], p[1], 0}; }

/// The part beyond x = 50 stands up.
std::array<double, 3> bent(Point p) {
  return p[0] < 50 ? flat(p) : std::array<double, 3>{50, p[1], p[0] - 50};
}

/// Two prongs up to x = 100, with a gap between them, on a bar up to x = 20.
std::vector<Point> fork(double gap) {
  const double low = 50 - gap / 2, high = 50 + gap / 2;
  return {{0, 0}, {100, 0}, {100, low}, {20, low}, {20, high}, {100, high}, {100, 100}, {0, 100}};
}

/// Only the upper prong stands up.
std::array<double, 3> upperBent(Point p) { return p[1] > 50 ? bent(p) : flat(p); }

bool isNear(const NearParts& near, std::uint32_t a, std::uint32_t b) {
  return std::count(near.edges.begin(), near.edges.end(),
                    std::array<std::uint32_t, 2>{std::min(a, b), std::max(a, b)}) > 0;
}

}  // namespace

TEST_CASE("parts far apart in space are near if less than the padding is between them",
          "[unwrap]") {
  for (const double gap : {0.5, 1.9}) {
    const NearParts near = findNearParts(placed(fork(gap), upperBent), 2);
    CHECK(near.gap == Approx(gap));
    CHECK(isNear(near, 2, 4));
    CHECK((near.point == 2 || near.point == 5));
  }
  CHECK(findNearParts(placed(fork(2.1), upperBent), 2).edges.empty());
  CHECK(findNearParts(placed(fork(0.5), upperBent), 0).edges.empty());
}

TEST_CASE("parts side by side in space are not near parts", "[unwrap]") {
  CHECK(findNearParts(placed(fork(0.5), flat), 2).edges.empty());
  CHECK(findNearParts(placed(fork(0.5), bent), 2).edges.empty());
}

TEST_CASE("two sides of a narrow part are not near parts", "[unwrap]") {
  // Whatever they look like in space, the chart itself lies between them.
  const auto torn = [](Point p) { return std::array<double, 3>{p[0], 1000 * p[1], 0}; };
  CHECK(findNearParts(placed({{0, 0}, {100, 0}, {100, 1}, {0, 1}}, torn), 2).edges.empty());
}

TEST_CASE("near parts are found on outlines of very short edges, in close to linear memory",
          "[unwrap]") {
  for (const int pieces : {3, 1000}) {
    const std::vector<Point> corners = fork(1);
    std::vector<Point> points;
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (int k = 0; k < pieces; ++k) {
        const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double share = static_cast<double>(k) / pieces;
        points.push_back({a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])});
      }
    const NearParts near = findNearParts(placed(points, upperBent), 8);
    CHECK(near.gap == Approx(1).epsilon(0.1));
    const auto p = static_cast<std::uint32_t>(pieces);
    // Every pair is of one side and the other; the bottom of the gap joins them.
    for (const auto& [a, b] : near.edges) {
      CHECK(a / p >= 1);
      CHECK(b / p <= 5);
    }
    CHECK(near.edges.size() < 2000 * points.size());
    CHECK_FALSE(near.edges.empty());
  }
}

TEST_CASE("long edges are near where they are, not only at their ends", "[unwrap]") {
  // A notch that is 30 wide and 1000 deep between two parts that stand upright on each other.
  const std::vector<Point> points = {{0, 0},      {1100, 0},    {1100, 485}, {100, 500},
                                     {1100, 515}, {1100, 1000}, {0, 1000}};
  const auto inSpace = [](Point p) {
    const double up = p[1] > 500 ? p[0] / 2 : 0;
    return std::array<double, 3>{p[0], p[1], up};
  };
  const NearParts near = findNearParts(placed(points, inSpace), 2);
  CHECK(near.edges == std::vector<std::array<std::uint32_t, 2>>{{2, 3}});
  CHECK(near.gap < 2);
}
