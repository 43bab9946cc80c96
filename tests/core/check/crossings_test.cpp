#include "check/crossings.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "catch.h"
#include "check/simple_polygon.h"
#include "support/instrumented.h"

using namespace abflat;

namespace {

using Polygon = std::vector<double>;

/// Checks all pairs by integer arithmetic on small coordinates.
std::size_t countByBruteForce(const Polygon& p) {
  const std::size_t n = p.size() / 2;
  const auto area = [&](std::size_t a, std::size_t b, std::size_t c) {
    const double d = (p[2 * b] - p[2 * a]) * (p[2 * c + 1] - p[2 * a + 1]) -
                     (p[2 * b + 1] - p[2 * a + 1]) * (p[2 * c] - p[2 * a]);
    return (d > 0) - (d < 0);
  };
  const auto inBox = [&](std::size_t a, std::size_t b, std::size_t c) {
    for (std::size_t d = 0; d < 2; ++d)
      if (p[2 * c + d] < std::min(p[2 * a + d], p[2 * b + d]) ||
          p[2 * c + d] > std::max(p[2 * a + d], p[2 * b + d]))
        return false;
    return true;
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const std::size_t a = i, b = (i + 1) % n, c = j, d = (j + 1) % n;
      if (b == c || d == a) {
        const std::size_t far1 = b == c ? a : b, joint = b == c ? b : a, far2 = b == c ? d : c;
        if (area(far1, joint, far2) == 0 && (inBox(far1, joint, far2) || inBox(joint, far2, far1)))
          ++count;
      } else if ((area(a, b, c) * area(a, b, d) < 0 && area(c, d, a) * area(c, d, b) < 0) ||
                 (area(a, b, c) == 0 && inBox(a, b, c)) || (area(a, b, d) == 0 && inBox(a, b, d)) ||
                 (area(c, d, a) == 0 && inBox(c, d, a)) || (area(c, d, b) == 0 && inBox(c, d, b))) {
        ++count;
      }
    }
  return count;
}

}  // namespace

TEST_CASE("crossings agree with brute force on random polygons of small integers") {
  std::mt19937 random(1);
  for (int repeat = 0; repeat < 400; ++repeat) {
    const std::size_t n = 4 + random() % 60;
    Polygon p;
    while (p.size() < 2 * n) {
      const double x = double(random() % 12), y = double(random() % 12);
      // Equal points in a row would make edges without a direction.
      if (!p.empty() && p[p.size() - 2] == x && p.back() == y) continue;
      if (p.size() == 2 * n - 2 && p[0] == x && p[1] == y) continue;
      p.insert(p.end(), {x, y});
    }
    CHECK(findCrossings(p).count == countByBruteForce(p));
  }
}

TEST_CASE("simple curves have no crossings, one pushed edge is found") {
  Polygon spiral;
  constexpr int kCount = 400;
  for (int side = 0; side < 2; ++side)
    for (int i = 0; i < kCount; ++i) {
      const int k = side == 0 ? i : kCount - 1 - i;
      const double u = 0.1 * k, r = 1 + 0.2 * u + 0.5 * side;
      spiral.insert(spiral.end(), {r * std::cos(u), r * std::sin(u)});
    }
  CHECK(findCrossings(spiral).count == 0);
  Polygon pushed = spiral;
  pushed[2 * 200] *= 1.12;
  pushed[2 * 200 + 1] *= 1.12;
  const Crossings found = findCrossings(pushed);
  CHECK(found.count == 2);
  for (const auto& pair : found.first) CHECK((pair[0] == 199 || pair[0] == 200));
}

TEST_CASE("coils, repeated places and coordinates that are no numbers are told apart") {
  // A thin band of 120 turns with few edges each, which are much longer than the band is wide.
  Polygon coil;
  constexpr int kCount = 3000;
  for (int side = 0; side < 2; ++side)
    for (int i = 0; i < kCount; ++i) {
      const int k = side == 0 ? i : kCount - 1 - i;
      const double turn = 0.04 * k, r = 1 + 0.02 * turn + 0.008 * side;
      coil.insert(coil.end(), {r * std::cos(2 * 3.14159 * turn), r * std::sin(2 * 3.14159 * turn)});
    }
  CHECK(findCrossings(coil).count == 0);
  Polygon pushed = coil;
  pushed[2 * 1000] *= 1.02;
  pushed[2 * 1000 + 1] *= 1.02;
  const Crossings found = findCrossings(pushed);
  CHECK(found.count == countByBruteForce(pushed));
  CHECK(found.count > 0);
  CHECK(found.first.size() == found.count);
  CHECK(std::is_sorted(found.first.begin(), found.first.end()));
  for (const auto& pair : found.first)
    CHECK((pair[0] == 999 || pair[0] == 1000 || pair[1] == 999 || pair[1] == 1000));
  CHECK(findCrossings(pushed, 1).first.size() == 1);

  const Polygon onePlace(2 * 100, 0.5);
  CHECK(findCrossings(onePlace).count == 100 * 99 / 2);
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    Polygon broken = coil;
    broken[77] = bad;
    CHECK(findCrossings(broken).first.size() <= 2 * kCount);
  }
}

TEST_CASE("the sweep agrees with counting on random polygons of small integers") {
  std::mt19937 random(5);
  int simple = 0;
  for (int repeat = 0; repeat < 4000; ++repeat) {
    const std::size_t n = 4 + random() % 6;
    Polygon p;
    std::set<std::pair<int, int>> used;
    while (p.size() < 2 * n) {
      const int x = static_cast<int>(random() % 9), y = static_cast<int>(random() % 9);
      // Polygons with repeated points are never simple, and edges between equal points have no
      // direction.
      if (used.insert({x, y}).second) p.insert(p.end(), {double(x), double(y)});
    }
    const bool isSimple = countByBruteForce(p) == 0;
    simple += isSimple;
    CHECK(isSimplePolygon(p) == isSimple);
  }
  CHECK(simple > 100);
  CHECK_FALSE(isSimplePolygon({0, 0, 4, 0, 2, 2, 4, 4, 0, 4, 2, 2}));
  CHECK_FALSE(isSimplePolygon({0, 0, 1, 0, INFINITY, 1, 0, 1}));
}

TEST_CASE("long edges side by side take no longer than others") {
  // There would be several thousand million pairs of their boxes.
  constexpr std::size_t kSpikes = test::cases(60000, 6000);
  const auto urchin = [](double hub) {
    Polygon p;
    for (std::size_t i = 0; i < 2 * kSpikes; ++i) {
      const double angle = 3.14159265358979 * double(i) / double(kSpikes);
      const double radius = i % 2 ? 1 : hub;
      p.insert(p.end(), {radius * std::cos(angle), radius * std::sin(angle)});
    }
    return p;
  };
  Polygon p = urchin(0.01);
  CHECK(findCrossings(p).count == 0);
  CHECK(isSimplePolygon(p));
  // One spike bent over to the one after the next.
  p[2 * 1001] = p[2 * 1005] * 0.99;
  p[2 * 1001 + 1] = p[2 * 1005 + 1] * 0.99;
  CHECK_FALSE(isSimplePolygon(p));
}
