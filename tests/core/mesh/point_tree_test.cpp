#include "mesh/point_tree.h"

#include <random>

#include "catch.h"
#include "mesh/clip_ears.h"

using namespace abflat;

TEST_CASE("a tree of points finds those in a triangle, as looking at all of them does") {
  std::mt19937 random(5);
  for (int round = 0; round < 60; ++round) {
    // On a coarse lattice many points lie on the rim, at corners or at the same place.
    const int steps = round % 2 ? 6 : 1 << 20;
    const auto coordinate = [&] { return static_cast<double>(random() % steps) / steps; };
    std::vector<Point2> points(1 + random() % 300);
    for (auto& p : points) p = {coordinate(), round % 3 ? coordinate() : 0.5};
    PointTree tree(points);
    std::vector<std::uint8_t> counts(points.size(), 0);
    for (int i = 0; i < 400; ++i) {
      const auto k = static_cast<std::uint32_t>(random() % points.size());
      counts[k] ? tree.remove(k) : tree.add(k);
      counts[k] = !counts[k];
      const auto a = points[random() % points.size()], b = points[random() % points.size()];
      const Point2 c{coordinate(), coordinate()};
      bool isIn = false;
      for (std::size_t j = 0; j < points.size(); ++j) {
        const auto& p = points[j];
        isIn = isIn || (counts[j] && p != a && p != b && p != c && turnOf(a, b, p) >= 0 &&
                        turnOf(b, c, p) >= 0 && turnOf(c, a, p) >= 0);
      }
      CHECK(tree.hasIn(a, b, c) == isIn);
    }
  }
}
