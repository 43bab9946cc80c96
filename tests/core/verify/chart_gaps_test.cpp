#include "verify/chart_gaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "catch.h"

using namespace abflat;

namespace {

/// Polygons with random corners around random places.
OutlineEdges randomPolygons(std::uint32_t charts, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  OutlineEdges out;
  for (std::uint32_t c = 0; c < charts; ++c) {
    const double x = share(random), y = share(random);
    const int corners = 3 + static_cast<int>(5 * share(random));
    std::vector<double> points;
    for (int k = 0; k < corners; ++k) {
      const double angle = 6.283 * k / corners, radius = size * (0.3 + share(random));
      points.push_back(x + radius * std::cos(angle));
      points.push_back(y + radius * std::sin(angle));
    }
    for (std::size_t k = 0; k < points.size(); k += 2) {
      const std::size_t next = (k + 2) % points.size();
      out.ends.insert(out.ends.end(), {points[k], points[k + 1], points[next], points[next + 1]});
      out.chart.push_back(c);
    }
  }
  return out;
}

/// By many points on both edges: never too small, hardly too large.
double sampled(const double* a, const double* b) {
  constexpr int kSteps = 200;
  double least = HUGE_VAL;
  for (int i = 0; i <= kSteps; ++i)
    for (int k = 0; k <= kSteps; ++k) {
      const double s = static_cast<double>(i) / kSteps, t = static_cast<double>(k) / kSteps;
      least = std::min(least, std::hypot(a[0] + s * (a[2] - a[0]) - b[0] - t * (b[2] - b[0]),
                                         a[1] + s * (a[3] - a[1]) - b[1] - t * (b[3] - b[1])));
    }
  return least;
}

OutlineEdges twoEdges(const std::array<double, 8>& ends) {
  return {{ends.begin(), ends.end()}, {0, 1}};
}

}  // namespace

TEST_CASE("the gap of two edges is the distance of their nearest points", "[verify]") {
  CHECK_FALSE(leastGap({}));
  CHECK_FALSE(leastGap({{0, 0, 1, 0, 1, 0, 1, 1}, {4, 4}}));
  CHECK(leastGap(twoEdges({0, 0, 1, 0, 0.5, 2, 0.5, 3}))->distance == 2);
  CHECK(leastGap(twoEdges({0, 0, 1, 0, 4, 4, 8, 8}))->distance == 5);
  CHECK(leastGap(twoEdges({0, 0, 1, 1, 0, 1, 1, 0}))->distance == 0);
  CHECK(leastGap(twoEdges({0, 0, 1, 0, 1, 0, 2, 5}))->distance == 0);
  CHECK(leastGap(twoEdges({0, 0, 0, 0, 3, 4, 3, 4}))->distance == 5);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  for (int run = 0; run < 30; ++run) {
    std::array<double, 8> ends;
    for (double& x : ends) x = share(random);
    const double found = leastGap(twoEdges(ends))->distance;
    const double expected = sampled(ends.data(), ends.data() + 4);
    CHECK(found < expected + 1e-12);
    CHECK(found > expected - 0.02);
  }
}

TEST_CASE("charts that are near each other are found among many", "[verify]") {
  for (const unsigned seed : {1u, 2u, 3u})
    for (const double size : {0.005, 0.02, 0.1}) {
      CAPTURE(seed, size);
      const OutlineEdges edges = randomPolygons(60, size, seed);
      // Each pair of edges by itself.
      std::vector<std::vector<double>> gap(60, std::vector<double>(60, HUGE_VAL));
      double least = HUGE_VAL;
      for (std::size_t i = 0; i < edges.chart.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
          const std::uint32_t a = edges.chart[k], b = edges.chart[i];
          if (a == b) continue;
          std::array<double, 8> ends;
          std::copy_n(&edges.ends[4 * k], 4, ends.begin());
          std::copy_n(&edges.ends[4 * i], 4, ends.begin() + 4);
          gap[a][b] = std::min(gap[a][b], leastGap(twoEdges(ends))->distance);
          least = std::min(least, gap[a][b]);
        }
      CHECK(leastGap(edges)->distance == least);
      for (const double reach : {0.01, 0.1, 2.0}) {
        std::vector<std::array<std::uint32_t, 2>> expected, found;
        for (std::uint32_t a = 0; a < 60; ++a)
          for (std::uint32_t b = a + 1; b < 60; ++b)
            if (gap[a][b] < reach) expected.push_back({a, b});
        for (const ChartGap& each : gapsBelow(edges, reach)) {
          found.push_back(each.charts);
          CHECK(each.distance == gap[each.charts[0]][each.charts[1]]);
          CHECK(edges.chart[each.edges[0]] == each.charts[0]);
          CHECK(edges.chart[each.edges[1]] == each.charts[1]);
        }
        CHECK(found == expected);
      }
    }
}
