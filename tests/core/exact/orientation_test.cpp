#include "exact/orientation.h"

#include <cmath>
#include <random>

#include "catch.h"

using namespace abflat;

namespace {

__extension__ using Wide = __int128;

}  // namespace

TEST_CASE("orientation of points next to a line is exact") {
  // Points of a tiny grid of neighbouring doubles around (0.5, 0.5) against the line through (12,
  // 12) and (24, 24).
  const double b[2] = {12, 12}, c[2] = {24, 24};
  constexpr double kUlp = 0x1p-53;
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) {
      const double a[2] = {0.5 + i * kUlp, 0.5 + j * kUlp};
      // Left of the upward diagonal iff y > x; a, b, c runs a -> b along it.
      const int wanted = (j > i) - (j < i);
      CHECK(orientation(b, c, a) == wanted);
      CHECK(orientation(c, a, b) == wanted);
      CHECK(orientation(c, b, a) == -wanted);
    }
}

TEST_CASE("orientation agrees with integer arithmetic") {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<long long> coordinate(-(1ll << 30), 1ll << 30), small(-3, 3);
  for (int n = 0; n < 20000; ++n) {
    long long p[6];
    for (int k = 0; k < 4; ++k) p[k] = coordinate(random);
    // The third point is close to the line through the first two.
    const long long m = small(random);
    p[4] = p[0] + m * (p[2] - p[0]) / 2 + small(random) % 2;
    p[5] = p[1] + m * (p[3] - p[1]) / 2 + small(random) % 2;
    const Wide det = static_cast<Wide>(p[2] - p[0]) * (p[5] - p[1]) -
                     static_cast<Wide>(p[3] - p[1]) * (p[4] - p[0]);
    double d[6];
    for (int k = 0; k < 6; ++k) d[k] = static_cast<double>(p[k]);
    CHECK(orientation(d, d + 2, d + 4) == (det > 0) - (det < 0));
  }
}
