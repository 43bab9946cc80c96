#include "base/portable_math.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/double_bits.h"

namespace abflat::portable {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
/// Adding and subtracting it rounds to an integer.
constexpr double kToInteger = 0x1.8p52;

/// A number as a double plus the remainder.
struct Pair {
  double high, low;
};
Pair operator-(const Pair& a, const Pair& b) { return {a.high - b.high, a.low - b.low}; }

constexpr Pair kPi = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr Pair kHalfPi = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
/// The high part has 32 bits, so its product with an exponent is exact.
constexpr Pair kLog2 = {0x1.62e42feep-1, 0x1.a39ef35793c76p-33};

/// x = quadrant * pi/2 + high + low, |high| <= pi/4.
struct Reduced {
  double high, low;
  unsigned quadrant;
};

Reduced reduce(double x) {
  if (!(std::abs(x) <= 1e5)) x = std::fmod(x, 2 * kPi.high);
  if (!std::isfinite(x)) return {kNan, 0, 0};
  // pi/2 in three parts; multiples of the first two by a small integer are exact.
  constexpr double kPart[] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};
  const double n = x * 0x1.45f306dc9c883p-1 + kToInteger - kToInteger;
  const double first = x - n * kPart[0], second = n * kPart[1];
  const double rest = first - second;
  const double tail = ((first - rest) - second) - n * kPart[2];
  const double high = rest + tail;
  return {high, (rest - high) + tail, static_cast<unsigned>(static_cast<std::int32_t>(n)) & 3};
}

/// Chebyshev approximation of (sin x / x - 1) / x^2 in x^2, |x| <= pi/4.
double sinReduced(const Reduced& r) {
  const double x = r.high, z = x * x, w = z * z;
  const double odd =
      0.008333333333330936 + w * (2.7557316093198404e-06 + w * 1.5917988979397435e-10);
  const double even = -0.00019841269836740532 + w * -2.5051129896450185e-08;
  const double p = -0.16666666666666666 + z * (odd + z * even);
  return x + (x * z * p + r.low * (1 - z / 2));
}

/// Chebyshev approximation of (cos x - 1 + x^2/2) / x^4 in x^2, |x| <= pi/4.
double cosReduced(const Reduced& r) {
  const double x = r.high, z = x * x, w = z * z;
  const double even = 0.041666666666666664 + w * (2.48015872987544e-05 + w * 2.087614504941318e-09);
  const double odd =
      -0.0013888888888887389 + w * (-2.755731726587808e-07 + w * -1.138254464534925e-11);
  const double half = z / 2, most = 1 - half;
  return most + (((1 - most) - half) + (w * (even + z * odd) - x * r.low));
}

/// atan(k / 8).
constexpr Pair kArcTangent[] = {{0, 0},
                                {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};

/// atan(small / large), 0 <= small <= large.
Pair arcTangent(double small, double large) {
  if (large == 0) return {0, 0};
  if (large > 1e300) small *= 0x1p-100, large *= 0x1p-100;
  if (large < 1e-280) small *= 0x1p100, large *= 0x1p100;
  const double k = 8 * (small / large) + kToInteger - kToInteger, center = k / 8;
  const double t = (small - center * large) / (large + center * small), z = t * t;
  const double series =
      1.0 / 3 - z * (1.0 / 5 - z * (1.0 / 7 - z * (1.0 / 9 - z * (1.0 / 11 - z * (1.0 / 13)))));
  const Pair& base = kArcTangent[static_cast<unsigned>(k)];
  return {base.high, t + (base.low - t * z * series)};
}

/// x * 2^exponent for an x near 1. Near the ends of the range only a call gets that right.
double scaled(double x, int exponent) {
  constexpr int kMost = 1020, kBias = 1023, kMantissa = 52;
  if (exponent < -kMost || exponent > kMost) return std::ldexp(x, exponent);
  return x * doubleOf(static_cast<std::uint64_t>(exponent + kBias) << kMantissa);
}

}  // namespace

SinCos sinCos(double x) {
  const Reduced r = reduce(x);
  const double sine = sinReduced(r), cosine = cosReduced(r);
  switch (r.quadrant) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

double sin(double x) {
  const Reduced r = reduce(x);
  const double value = (r.quadrant & 1) != 0 ? cosReduced(r) : sinReduced(r);
  return (r.quadrant & 2) != 0 ? -value : value;
}

double cos(double x) {
  const Reduced r = reduce(x);
  const double value = (r.quadrant & 1) != 0 ? sinReduced(r) : cosReduced(r);
  return r.quadrant == 1 || r.quadrant == 2 ? -value : value;
}

double log(double x) {
  if (!(x > 0) || x == kInfinity) return x == 0 ? -kInfinity : x < 0 ? kNan : x;
  int exponent = 0;
  if (x < std::numeric_limits<double>::min()) x *= 0x1p54, exponent = -54;
  std::uint64_t bits = bitsOf(x);
  // x = 2^exponent * m with m in [sqrt(1/2), sqrt(2)).
  constexpr std::uint64_t kRootHalf = 0x3fe6a09e667f3bcd;
  const auto shift = static_cast<std::int64_t>(bits - kRootHalf) >> 52;
  exponent += static_cast<int>(shift);
  bits -= static_cast<std::uint64_t>(shift) << 52;
  const double m = doubleOf(bits);
  // log(1 + f) = 2 atanh(s) with s = f / (2 + f), a series in s^2 < 0.0295.
  const double f = m - 1, s = f / (2 + f), z = s * s, w = z * z;
  const double even =
      2.0 / 3 + w * (2.0 / 7 + w * (2.0 / 11 + w * (2.0 / 15 + w * (2.0 / 19 + w * (2.0 / 23)))));
  const double odd = 2.0 / 5 + w * (2.0 / 9 + w * (2.0 / 13 + w * (2.0 / 17 + w * (2.0 / 21))));
  const double series = z * (even + z * odd), half = f * f / 2;
  return exponent * kLog2.high - ((half - (s * (half + series) + exponent * kLog2.low)) - f);
}

double exp(double x) {
  if (!(x > -746 && x < 710)) return x > 0 ? kInfinity : x < 0 ? 0 : x;
  const double n = x * 0x1.71547652b82fep+0 + kToInteger - kToInteger;
  const double high = x - n * kLog2.high, low = n * kLog2.low, r = high - low;
  // Taylor: |r| <= log(2)/2.
  double p = 1.0 / 6227020800;
  for (const double inverse :
       {1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040,
        1.0 / 720, 1.0 / 120, 1.0 / 24, 1.0 / 6, 1.0 / 2})
    p = p * r + inverse;
  return scaled(1 + (high - (low - r * r * p)), static_cast<int>(n));
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNan;
  double rise = std::abs(y), run = std::abs(x);
  if (rise == kInfinity || run == kInfinity) {
    rise = rise == kInfinity ? 1 : 0;
    run = run == kInfinity ? 1 : 0;
  }
  const bool isSteep = rise > run;
  Pair angle = isSteep ? kHalfPi - arcTangent(run, rise) : arcTangent(rise, run);
  if (std::signbit(x)) angle = kPi - angle;
  return std::copysign(angle.high + angle.low, y);
}

double hypot(double x, double y) { return hypot(x, y, 0); }

double hypot(double x, double y, double z) {
  const double square = x * x + y * y + z * z;
  if (square > 1e-280 && square < 1e280) return std::sqrt(square);
  const double largest = std::max({std::abs(x), std::abs(y), std::abs(z)});
  if (std::isinf(x) || std::isinf(y) || std::isinf(z)) return kInfinity;
  if (std::isnan(square) || largest == 0) return square;
  const int exponent = std::ilogb(largest);
  const double a = std::ldexp(x, -exponent), b = std::ldexp(y, -exponent),
               c = std::ldexp(z, -exponent);
  return std::ldexp(std::sqrt(a * a + b * b + c * c), exponent);
}

}  // namespace abflat::portable
