#include "exact/overlap.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "catch.h"

using namespace abflat;

namespace {

bool overlap(std::vector<double> a, const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return findOverlap(a).has_value();
}

/// The area shared by two triangles, found by clipping one at the edges of the other.
double commonArea(const double* a, const double* b) {
  std::vector<std::array<double, 2>> polygon = {{b[0], b[1]}, {b[2], b[3]}, {b[4], b[5]}};
  for (std::size_t k = 0; k < 3; ++k) {
    const double *from = a + 2 * k, *to = a + 2 * ((k + 1) % 3);
    const auto side = [&](const std::array<double, 2>& p) {
      return (to[0] - from[0]) * (p[1] - from[1]) - (to[1] - from[1]) * (p[0] - from[0]);
    };
    std::vector<std::array<double, 2>> inside;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto p = polygon[i], q = polygon[(i + 1) % polygon.size()];
      const double sp = side(p), sq = side(q);
      if (sp >= 0) inside.push_back(p);
      if ((sp > 0 && sq < 0) || (sp < 0 && sq > 0)) {
        const double s = sp / (sp - sq);
        inside.push_back({p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])});
      }
    }
    polygon = inside;
  }
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    twice += p[0] * q[1] - p[1] * q[0];
  }
  return twice / 2;
}

}  // namespace

TEST_CASE("triangles that touch do not overlap, those that cover each other do", "[overlap]") {
  const std::vector<double> t = {0, 0, 1, 0, 0, 1};
  CHECK(overlap(t, t));
  CHECK(overlap(t, {0.2, 0.2, 0.3, 0.2, 0.2, 0.3}));
  CHECK(overlap(t, {-1, -1, 3, -1, -1, 3}));
  CHECK(overlap(t, {0.4, 0.4, 2, 0.4, 0.4, 2}));
  CHECK(overlap(t, {-1, 0.2, 3, 0.2, -1, 0.3}));
  CHECK_FALSE(overlap(t, {1, 0, 1, 1, 0, 1}));
  CHECK_FALSE(overlap(t, {0.5, 0.5, 1, 1, 0, 1.5}));
  CHECK_FALSE(overlap(t, {0, 0, -1, 0, 0, -1}));
  CHECK_FALSE(overlap(t, {0.25, 0, 0, -1, 0.75, 0}));
  CHECK_FALSE(overlap(t, {0.9, 0.9, 2, 0.9, 0.9, 2}));
  // A needle that overlaps it by as little as doubles can resolve.
  CHECK(overlap(t, {0.5, std::nextafter(0.5, 0), 1, 1, 0.5, 1}));
  CHECK_FALSE(findOverlap({}).has_value());
  CHECK_FALSE(findOverlap({1, 1, 1, 1, 1, 1}).has_value());
}

TEST_CASE("a grid of triangles does not overlap until one is moved", "[overlap]") {
  std::vector<double> grid;
  for (double y = 0; y < 30; ++y)
    for (double x = 0; x < 50; ++x) {
      grid.insert(grid.end(), {x, y, x + 1, y, x, y + 1});
      grid.insert(grid.end(), {x + 1, y, x + 1, y + 1, x, y + 1});
    }
  CHECK_FALSE(findOverlap(grid).has_value());
  std::vector<double> moved = grid;
  moved[6 * 1234] -= 0x1p-40;
  const auto pair = findOverlap(moved);
  REQUIRE(pair.has_value());
  CHECK(((*pair)[0] == 1234 || (*pair)[1] == 1234));
}

TEST_CASE("the overlap of random triangles is that of their areas", "[overlap]") {
  std::mt19937 random(5);
  const auto next = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int round = 0; round < 200; ++round) {
    std::vector<double> all;
    while (all.size() < 6 * 8) {
      const double x = 4 * next(), y = 4 * next();
      double t[6];
      for (std::size_t k = 0; k < 6; ++k) t[k] = (k % 2 ? y : x) + next();
      const double twice = (t[2] - t[0]) * (t[5] - t[1]) - (t[3] - t[1]) * (t[4] - t[0]);
      if (twice > 1e-3) all.insert(all.end(), t, t + 6);
    }
    double most = 0;
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t j = i + 1; j < 8; ++j)
        most = std::max(most, commonArea(&all[6 * i], &all[6 * j]));
    if (most > 0 && most < 1e-12) continue;
    const auto pair = findOverlap(all);
    CHECK(pair.has_value() == (most > 0));
    if (pair) CHECK(commonArea(&all[6 * (*pair)[0]], &all[6 * (*pair)[1]]) > 0);
  }
}

TEST_CASE("overlap: between groups only, whichever way round") {
  const std::vector<double> uv = {0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 2, 0, 3, 0, 2, 1};
  CHECK(findOverlapBetween(uv, {0, 1, 2}) == std::array<std::uint32_t, 2>{0, 1});
  CHECK(!findOverlapBetween(uv, {0, 0, 2}));
}

TEST_CASE("all triangles that overlap another are found, as by comparing each two", "[overlap]") {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> place(0, 24), size(-2, 2);
  for (int round = 0; round < 20; ++round) {
    std::vector<double> uv;
    for (int i = 0; i < 60; ++i) {
      const double u = place(random), v = place(random);
      uv.insert(uv.end(),
                {u, v, u + size(random), v + size(random), u + size(random), v + size(random)});
      if (i % 10 == 0) uv.insert(uv.end(), uv.end() - 6, uv.end());  // a copy
    }
    const std::vector<std::uint8_t> found = overlappingTriangles(uv);
    const std::size_t count = uv.size() / 6;
    REQUIRE(found.size() == count);
    std::set<std::array<std::uint32_t, 2>> pairs;
    forOverlaps(
        uv, [](std::uint32_t, std::uint32_t) { return false; },
        [&](std::uint32_t i, std::uint32_t k) {
          CHECK(i < k);
          pairs.insert({i, k});
        });
    // Of each eleven, the first two are copies of each other.
    const auto hasCopy = [](std::size_t i) { return i % 11 < 2; };
    for (std::size_t i = 0; i < count; ++i) {
      bool overlapsAny = false;
      for (std::size_t j = 0; j < count; ++j) {
        if (i == j) continue;
        std::vector<double> both(uv.begin() + static_cast<std::ptrdiff_t>(6 * i),
                                 uv.begin() + static_cast<std::ptrdiff_t>(6 * i + 6));
        both.insert(both.end(), uv.begin() + static_cast<std::ptrdiff_t>(6 * j),
                    uv.begin() + static_cast<std::ptrdiff_t>(6 * j + 6));
        const bool doOverlap = findOverlapBetween(both, {0, 1}).has_value();
        overlapsAny = overlapsAny || doOverlap;
        if (i < j && !hasCopy(i) && !hasCopy(j))
          CHECK((pairs.count({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)}) > 0) ==
                doOverlap);
      }
      CHECK((found[i] != 0) == overlapsAny);
    }
  }
}

TEST_CASE("thousands of copies of a triangle all overlap", "[overlap]") {
  std::vector<double> uv;
  for (int i = 0; i < 20000; ++i) uv.insert(uv.end(), {0, 0, 1, 0, 0, 1});
  const std::vector<std::uint8_t> found = overlappingTriangles(uv);
  CHECK(std::count(found.begin(), found.end(), 1) == 20000);
}

TEST_CASE("overlaps are the same at any scale that doubles have", "[overlap]") {
  std::mt19937 random(5);
  std::vector<double> uv;
  for (int i = 0; i < 6 * 60; ++i) uv.push_back(static_cast<double>(random() % 64));
  const std::vector<std::uint8_t> expected = overlappingTriangles(uv);
  for (const int exponent : {-1074, -1060, -1022, -700, -300, 300, 700, 1017}) {
    std::vector<double> scaled = uv;
    for (double& x : scaled) x = std::ldexp(x, exponent);
    CHECK(overlappingTriangles(scaled) == expected);
  }
}
