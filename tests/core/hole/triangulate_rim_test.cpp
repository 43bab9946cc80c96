#include "hole/triangulate_rim.h"

#include <map>

#include "catch.h"

using namespace abflat;

namespace {

Rim rimOf(std::vector<Vec3> points) {
  const std::size_t n = points.size();
  return {IdVector<RimIndex, Vec3>(std::move(points)), IdVector<RimIndex, std::uint8_t>(n, 0),
          [](RimIndex, RimIndex) { return false; }};
}

/// Star-shaped with deep notches, tilted and bent.
Rim jagged(std::uint32_t n, double depth) {
  std::vector<Vec3> points;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double a = 2 * kPi * i / n, r = i % 3 == 0 ? 1 - depth : 1;
    const double x = r * portable::cos(a), y = r * portable::sin(a);
    points.push_back({x, y + 0.2 * x, 0.5 * x - 0.3 * y + 0.1 * x * y});
  }
  return rimOf(std::move(points));
}

}  // namespace

TEST_CASE("what fills a hole has each of its sides once, and every other edge twice", "[holes]") {
  for (const std::uint32_t n : {3u, 4u, 7u, 30u, 240u})
    for (const double depth : {0.0, 0.3, 0.7}) {
      const auto triangles = triangulateRim(jagged(n, n > 4 ? depth : 0));
      REQUIRE(triangles.size() == n - 2);
      std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
      for (const auto& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
      for (const auto& [edge, count] : uses) {
        CHECK(count == 1);
        const bool isSide = (edge.first + 1) % n == edge.second;
        CHECK(uses.count({edge.second, edge.first}) == (isSide ? 0 : 1));
      }
      for (std::uint32_t i = 0; i < n; ++i) CHECK(uses.count({i, (i + 1) % n}) == 1);
    }
}

TEST_CASE("a rim that crosses or touches itself is not filled", "[holes]") {
  CHECK(triangulateRim(rimOf({{0, 0, 0}, {1, 0, 0}})).empty());
  CHECK(triangulateRim(rimOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}})).empty());
  CHECK(triangulateRim(rimOf({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}})).empty());
  // Passes through one place twice.
  CHECK(
      triangulateRim(rimOf({{0, 0, 0}, {1, -1, 0}, {1, 1, 0}, {0, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}))
          .empty());
}

TEST_CASE("an edge of the surface is not made a second time", "[holes]") {
  Rim square = rimOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  square.isJoined = [](RimIndex a, RimIndex b) { return a % 2 == 0 && b % 2 == 0; };
  for (const auto& t : triangulateRim(square))
    for (std::size_t k = 0; k < 3; ++k) CHECK(t[k] + t[(k + 1) % 3] != 2);
  square.isJoined = [](RimIndex, RimIndex) { return true; };
  CHECK(triangulateRim(square).empty());
}

TEST_CASE("a vertex with one triangle gets two more", "[holes]") {
  Rim rim = jagged(12, 0);
  for (const std::uint32_t corner : {0u, 5u, 7u}) rim.isCorner[RimIndex(corner)] = 1;
  std::vector<int> uses(12, 0);
  const auto triangles = triangulateRim(rim);
  REQUIRE(!triangles.empty());
  for (const auto& t : triangles)
    for (const std::uint32_t i : t) ++uses[i];
  for (const std::uint32_t corner : {0u, 5u, 7u}) CHECK(uses[corner] >= 2);
}
