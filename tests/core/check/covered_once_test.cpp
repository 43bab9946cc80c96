#include "check/covered_once.h"

#include <cmath>
#include <random>

#include "catch.h"

using namespace abflat;

namespace {

using Point = std::array<double, 2>;
using Loop = std::vector<Point>;

Curves curvesOf(const std::vector<Loop>& loops) {
  Curves out;
  for (const Loop& loop : loops) {
    for (const Point& p : loop) out.points.insert(out.points.end(), p.begin(), p.end());
    out.ends.push_back(static_cast<std::uint32_t>(out.points.size() / 2));
  }
  return out;
}

bool isCoveredOnce(const std::vector<Loop>& loops) { return !findWrongCover(curvesOf(loops)); }

Loop square(double x, double y, double side, bool isClockwise = false) {
  Loop out = {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
  if (isClockwise) out = {out[0], out[3], out[2], out[1]};
  return out;
}

/// For small integers, which doubles represent exactly.
double cross(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool isOn(const Point& a, const Point& b, const Point& p) {
  return cross(a, b, p) == 0 && std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) &&
         std::min(a[1], b[1]) <= p[1] && p[1] <= std::max(a[1], b[1]);
}

bool meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (isOn(a, b, c) || isOn(a, b, d) || isOn(c, d, a) || isOn(c, d, b)) return true;
  return cross(a, b, c) * cross(a, b, d) < 0 && cross(c, d, a) * cross(c, d, b) < 0;
}

int windingAt(const std::vector<Loop>& loops, const Point& p) {
  int out = 0;
  for (const Loop& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if (a[1] <= p[1] && b[1] > p[1] && cross(a, b, p) > 0) ++out;
      if (b[1] <= p[1] && a[1] > p[1] && cross(a, b, p) < 0) --out;
    }
  return out;
}

/// Checks all pairs of edges, and the winding number beside each edge.
bool isCoveredOnceByBruteForce(const std::vector<Loop>& loops) {
  struct Edge {
    Point a, b;
    std::size_t loop, i, count;
  };
  std::vector<Edge> edges;
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (std::size_t i = 0; i < loops[l].size(); ++i)
      edges.push_back({loops[l][i], loops[l][(i + 1) % loops[l].size()], l, i, loops[l].size()});
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const Edge &e = edges[i], &f = edges[j];
      const bool follows = e.loop == f.loop && (e.i + 1) % e.count == f.i;
      const bool precedes = e.loop == f.loop && (f.i + 1) % f.count == e.i;
      if (follows    ? isOn(e.a, e.b, f.b) || isOn(f.a, f.b, e.a)
          : precedes ? isOn(f.a, f.b, e.b) || isOn(e.a, e.b, f.a)
                     : meet(e.a, e.b, f.a, f.b))
        return false;
    }
  for (const Edge& e : edges) {
    // Nearer to the edge's middle than any other edge between integers below 16 can come.
    const double x = (e.a[0] + e.b[0]) / 2, y = (e.a[1] + e.b[1]) / 2;
    const double nx = (e.a[1] - e.b[1]) * 1e-5, ny = (e.b[0] - e.a[0]) * 1e-5;
    if (windingAt(loops, {x + nx, y + ny}) != 1 || windingAt(loops, {x - nx, y - ny}) != 0)
      return false;
  }
  return true;
}

}  // namespace

TEST_CASE("charts, charts in holes of others, and nothing twice", "[certificate]") {
  const Loop chart = square(0, 0, 10), hole = square(2, 2, 6, true), inHole = square(4, 4, 2);
  CHECK(isCoveredOnce({}));
  CHECK(isCoveredOnce({chart}));
  CHECK(isCoveredOnce({chart, square(11, 0, 1)}));
  CHECK(isCoveredOnce({chart, hole}));
  CHECK(isCoveredOnce({inHole, chart, hole}));
  CHECK_FALSE(isCoveredOnce({chart, inHole}));                  // on the chart
  CHECK_FALSE(isCoveredOnce({square(0, 0, 10, true)}));         // clockwise
  CHECK_FALSE(isCoveredOnce({chart, square(2, 2, 6)}));         // hole with the wrong orientation
  CHECK_FALSE(isCoveredOnce({chart, square(20, 2, 6, true)}));  // hole outside any chart
  CHECK_FALSE(isCoveredOnce({chart, hole, square(1, 4, 2)}));   // across the hole's rim
  CHECK_FALSE(isCoveredOnce({chart, square(10, 0, 1)}));        // touches along an edge
  CHECK_FALSE(isCoveredOnce({chart, square(10, 10, 1)}));       // at a corner
  CHECK_FALSE(isCoveredOnce({chart, {{10, 5}, {12, 4}, {12, 6}}}));  // a corner on an edge
  CHECK(isCoveredOnce({chart, {{std::nextafter(10, 11), 5}, {12, 4}, {12, 6}}}));
  CHECK_FALSE(isCoveredOnce({chart, {{std::nextafter(10, 9), 5}, {12, 4}, {12, 6}}}));
  CHECK_FALSE(isCoveredOnce({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}));  // figure of eight
  CHECK_FALSE(isCoveredOnce({{{0, 0}, {4, 0}, {2, 0}}}));          // without area
}

TEST_CASE("what is covered once is so by brute force", "[certificate]") {
  std::mt19937 engine(11);
  const auto below = [&](unsigned n) { return static_cast<unsigned>(engine() % n); };
  int once = 0;
  for (int round = 0; round < 4000; ++round) {
    std::vector<Loop> loops(1 + below(3));
    for (Loop& loop : loops) {
      loop.resize(3 + below(3));
      const double x = below(10), y = below(10);
      for (Point& p : loop) p = {x + below(5), y + below(5)};
      bool isRepeated = false;
      for (std::size_t i = 0; i < loop.size(); ++i)
        isRepeated = isRepeated || loop[i] == loop[(i + 1) % loop.size()];
      if (isRepeated) loop = square(x, y, 1);
    }
    const bool expected = isCoveredOnceByBruteForce(loops);
    once += expected;
    CHECK(isCoveredOnce(loops) == expected);
  }
  CHECK(once > 100);
}

TEST_CASE("long boundaries that coil round each other take n log n", "[certificate]") {
  std::vector<Loop> loops;
  constexpr int kCount = 50000;
  for (int strip = 0; strip < 2; ++strip) {
    Loop loop;
    for (int side = 0; side < 2; ++side)
      for (int i = 0; i < kCount; ++i) {
        const int k = side == 0 ? i : kCount - 1 - i;
        const double turn = 0.002 * k, r = 1 + turn + 0.4 * strip + (side == 0 ? 0.3 : 0);
        loop.push_back({r * std::cos(2 * 3.14159 * turn), r * std::sin(2 * 3.14159 * turn)});
      }
    loops.push_back(loop);
  }
  CHECK(isCoveredOnce(loops));
  loops[1][kCount / 2][0] *= 1.5;
  CHECK_FALSE(isCoveredOnce(loops));
}
