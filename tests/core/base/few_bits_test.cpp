#include "base/few_bits.h"

#include <limits>
#include <random>

#include "catch.h"

namespace abflat {
namespace {

/// The nearest number of 21 bits; of two, the larger.
double rounded(double x) {
  int exponent = 0;
  const double part = std::frexp(x, &exponent);
  return std::ldexp(std::floor(std::ldexp(part, 21) + 0.5), exponent - 21);
}

TEST_CASE("few bits: the nearest number of 21 bits") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> mantissa(-2, 2);
  std::uniform_int_distribution<int> exponent(-1070, 1020);
  for (int i = 0; i < 20000; ++i) {
    const double x = std::ldexp(mantissa(random), exponent(random));
    INFO(x);
    REQUIRE(inFewBits(x) == rounded(x));
  }
}

TEST_CASE("few bits: halves, ends of the range and what is no number") {
  const double half = 1 + 0x1p-21;
  for (const double x : {half, -half, 2 - 0x1p-21, -2 + 0x1p-21, 0x1p-1022, 0x1p-1074,
                         3 * 0x1p-1060, std::numeric_limits<double>::max(), 0.0, -0.0})
    CHECK(inFewBits(x) == rounded(x));
  CHECK_FALSE(std::signbit(inFewBits(-0.0)));
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(inFewBits(infinity) == infinity);
  CHECK(inFewBits(-infinity) == -infinity);
  CHECK(std::isnan(inFewBits(std::numeric_limits<double>::quiet_NaN())));
}

}  // namespace
}  // namespace abflat
