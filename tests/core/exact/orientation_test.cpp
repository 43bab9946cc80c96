#include "exact/orientation.h"

#include <algorithm>
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

TEST_CASE("orientation is exact for numbers of any size") {
  std::mt19937_64 random(2);
  std::uniform_int_distribution<int> digit(-9, 9), exponent(-1070, 1019);
  for (int n = 0; n < 20000; ++n) {
    // Multiples of two powers of two, so that integers tell the sign: those of the larger one
    // decide, unless they are in line.
    const int large = exponent(random), small = std::min(large, exponent(random));
    const bool isFar = large - small > 60;
    double p[6];
    Wide whole[6];
    for (int k = 0; k < 6; ++k) {
      const int high = digit(random), low = digit(random);
      p[k] = std::ldexp(high, large);
      whole[k] = high;
      if (k % 2 == 1 && isFar) {
        p[k] = std::ldexp(low, small);  // v is small, u is large
        whole[k] = low;
      }
    }
    const Wide det = (whole[2] - whole[0]) * (whole[5] - whole[1]) -
                     (whole[3] - whole[1]) * (whole[4] - whole[0]);
    CHECK(orientation(p, p + 2, p + 4) == (det > 0) - (det < 0));
  }
  // Next to a line far from the origin, and smallest numbers beside large ones.
  constexpr double kLeast = 4.9e-324;
  const double a[2] = {0, 0}, b[2] = {1, 1}, c[2] = {kLeast, 2 * kLeast}, d[2] = {1e308, -1e308};
  CHECK(orientation(a, b, c) == 1);
  CHECK(orientation(b, a, c) == -1);
  CHECK(orientation(c, d, b) == 1);
  CHECK(orientation(a, c, c) == 0);
  const double e[2] = {1 + 0x1p-52, 1}, f[2] = {1, 1 - 0x1p-53};
  CHECK(orientation(f, e, a) == -orientation(a, e, f));
}
