#include "refine/near_pairs.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "catch.h"

using namespace abflat;

TEST_CASE("points near edges are found wherever they are", "[refine]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1, 1);
  for (const double reach : {1e-3, 0.02, 0.3}) {
    std::vector<double> points;
    // Short edges, and long ones that cross all of them.
    for (int i = 0; i < 300; ++i) {
      const double angle = 0.1 * i, radius = i % 50 == 0 ? 3 : 0.003 * i;
      points.insert(points.end(), {radius * std::cos(angle) + 0.01 * place(random),
                                   radius * std::sin(angle) + 0.01 * place(random)});
    }
    const std::vector<NearPair> found = findNearPairs(points, reach);
    const auto n = static_cast<std::uint32_t>(points.size() / 2);
    std::size_t near = 0, missed = 0;
    for (std::uint32_t p = 0; p < n; ++p)
      for (std::uint32_t e = 0; e < n; ++e) {
        const std::uint32_t f = (e + 1) % n;
        if (e == p || f == p) continue;
        const double ux = points[2 * f] - points[2 * e], uy = points[2 * f + 1] - points[2 * e + 1];
        const double x = points[2 * p] - points[2 * e], y = points[2 * p + 1] - points[2 * e + 1];
        const double along = std::clamp((x * ux + y * uy) / (ux * ux + uy * uy), 0.0, 1.0);
        if (std::hypot(x - along * ux, y - along * uy) > reach) continue;
        ++near;
        missed += std::none_of(found.begin(), found.end(), [&](const NearPair& pair) {
          return pair.point == p && pair.edge == e;
        });
      }
    CHECK(near > 0);
    CHECK(missed == 0);
  }
}

TEST_CASE("only pairs of points and edges that are asked for are found, and all of them",
          "[refine]") {
  constexpr double kReach = 0.2;
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(-1, 1);
  std::vector<double> points;
  std::vector<std::uint8_t> isAsked;
  for (int i = 0; i < 200; ++i) {
    points.insert(points.end(), {place(random), place(random)});
    isAsked.push_back(place(random) > 0);
  }
  std::size_t wanted = 0, found = 0;
  for (const NearPair& pair : findNearPairs(points, kReach))
    wanted += isAsked[pair.point] && isAsked[pair.edge];
  forNearPairs(points, kReach, isAsked, [&](const NearPair& pair) {
    ++found;
    CHECK((isAsked[pair.point] && isAsked[pair.edge]));
  });
  CHECK(wanted > 0);
  CHECK(found == wanted);
}
