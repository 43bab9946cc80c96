#include "mesh/weld.h"

#include <cmath>
#include <random>

#include "catch.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// The same by comparing all pairs.
std::vector<std::uint32_t> weldedByPairs(const std::vector<double>& p, double reach) {
  std::vector<std::uint32_t> of(p.size() / 3);
  for (std::uint32_t v = 0; v < of.size(); ++v) {
    of[v] = v;
    for (std::uint32_t u = 0; u < v && of[v] == v; ++u) {
      if (of[u] != u) continue;
      const double x = p[3 * u] - p[3 * v], y = p[3 * u + 1] - p[3 * v + 1],
                   z = p[3 * u + 2] - p[3 * v + 2];
      if (std::sqrt(x * x + y * y + z * z) <= reach) of[v] = u;
    }
  }
  return of;
}

}  // namespace

TEST_CASE("vertices at one place become the first of them") {
  const Welding w = weldVertices({0, 0, 0, 1, 0, 0, 0, 0, 0, -0.0, 0, 0, 1, 0, 1e-9});
  CHECK(w.ofVertex == std::vector<std::uint32_t>{0, 1, 0, 0, 1});
  CHECK(w.merged == 3);
}

TEST_CASE("welding agrees with the comparison of all pairs, and does not depend on the unit") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 1), shift(-1, 1);
  constexpr double kTolerance = 1e-3;
  std::vector<double> p{0, 0, 0, 1, 1, 1};  // so that the diagonal is known
  for (int cluster = 0; cluster < 60; ++cluster) {
    const double at[3] = {place(random), place(random), place(random)};
    // Pairs are either clearly within the tolerance or clearly not.
    for (int i = 0; i < 4; ++i)
      for (const double x : at)
        p.push_back(std::clamp(x + (i < 3 ? 0.2 : 5) * kTolerance * shift(random), 0.0, 1.0));
  }
  const std::vector<std::uint32_t> wanted = weldedByPairs(p, kTolerance * std::sqrt(3.0));
  for (const double unit : {1.0, 1e-6, 1e6, 1e-300, 1e300}) {
    std::vector<double> q = p;
    for (double& x : q) x *= unit;
    CHECK(weldVertices(q, kTolerance).ofVertex == wanted);
  }
}

TEST_CASE("many vertices at one place, none, and one") {
  CHECK(weldVertices({}).merged == 0);
  CHECK(weldVertices({1, 2, 3}).ofVertex == std::vector<std::uint32_t>{0});
  const Welding w = weldVertices(std::vector<double>(3 * 50000, 4.0));
  CHECK(w.merged == 49999);
}
