#include "base/portable_math.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

#include "base/double_bits.h"
#include "catch.h"

using namespace abflat;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = 3.14159265358979323846;

/// Angles up to which the C library knows sines to more digits than a double has. That of Windows
/// asks the processor, whose pi is too short for large ones.
#ifdef _WIN32
constexpr double kRangesOfAngles[] = {1e-9, 1.0};
#else
constexpr double kRangesOfAngles[] = {1e-9, 1.0, kPi, 100.0, 1e5};
#endif

/// Distance from the truth, in units in its last place.
double error(double value, long double truth) {
  const double rounded = std::abs(static_cast<double>(truth));
  const double unit = std::nextafter(rounded, kInfinity) - rounded;
  return static_cast<double>(std::abs(static_cast<long double>(value) - truth) / unit);
}

template <typename Function>
double worst(double from, double to, Function&& errorAt) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(from, to);
  double out = 0;
  for (int i = 0; i < 200000; ++i) out = std::max(out, errorAt(uniform(random)));
  return out;
}

}  // namespace

TEST_CASE("portable functions are as exact as they promise", "[math]") {
  for (const double range : kRangesOfAngles) {
    CHECK(worst(-range, range, [](double x) {
            return error(portable::sin(x), std::sin(static_cast<long double>(x)));
          }) < 1.5);
    CHECK(worst(-range, range, [](double x) {
            return error(portable::cos(x), std::cos(static_cast<long double>(x)));
          }) < 1.5);
  }
  for (const double range : {1e-300, 1e-9, 1.0, 2.0, 1e9, 1e300})
    CHECK(worst(0, range, [](double x) {
            return error(portable::log(x), std::log(static_cast<long double>(x)));
          }) < 1.5);
  CHECK(worst(0.9, 1.1, [](double x) {
          return error(portable::log(x), std::log(static_cast<long double>(x)));
        }) < 1.5);
  for (const double range : {1e-9, 1.0, 700.0})
    CHECK(worst(-range, range, [](double x) {
            return error(portable::exp(x), std::exp(static_cast<long double>(x)));
          }) < 1.5);
  for (const double range : {1e-9, 1.0, kPi}) {
    const auto at = [](double angle, double size) {
      const double y = size * std::sin(angle), x = size * std::cos(angle);
      return error(portable::atan2(y, x),
                   std::atan2(static_cast<long double>(y), static_cast<long double>(x)));
    };
    for (const double size : {1e-200, 1.0, 1e200})
      CHECK(worst(-range, range, [&](double angle) { return at(angle, size); }) < 2);
  }
  for (const double size : {5e-324, 1e-300, 1.0, 1e300})
    CHECK(worst(0, size, [&](double x) {
            return error(
                portable::hypot(x, size, x / 3),
                std::sqrt(static_cast<long double>(x) * x + static_cast<long double>(size) * size +
                          static_cast<long double>(x / 3) * (x / 3)));
          }) < 1.5);
}

TEST_CASE("portable functions at the ends of their ranges", "[math]") {
  CHECK(bitsOf(portable::sin(0.0)) == bitsOf(0.0));
  CHECK(portable::cos(0.0) == 1);
  CHECK(std::isnan(portable::sin(kInfinity)));
  CHECK(std::isnan(portable::cos(kNan)));
  for (double x = -20; x < 20; x += 0.37) {
    const portable::SinCos both = portable::sinCos(x);
    CHECK(both.sin == portable::sin(x));
    CHECK(both.cos == portable::cos(x));
  }
  CHECK(portable::log(1.0) == 0);
  CHECK(portable::log(0.0) == -kInfinity);
  CHECK(portable::log(kInfinity) == kInfinity);
  CHECK(std::isnan(portable::log(-1.0)));
  CHECK(portable::log(5e-324) == Approx(std::log(5e-324)));
  CHECK(portable::exp(0.0) == 1);
  CHECK(portable::exp(1000.0) == kInfinity);
  CHECK(portable::exp(-1000.0) == 0);
  CHECK(portable::exp(-740.0) == Approx(std::exp(-740.0)));
  CHECK(std::isnan(portable::exp(kNan)));
  CHECK(portable::hypot(0.0, 0.0) == 0);
  CHECK(portable::hypot(kInfinity, 1.0) == kInfinity);
  CHECK(std::isnan(portable::hypot(kNan, 1.0)));
  const double ends[] = {0.0, -0.0, 1.0, -1.0, kInfinity, -kInfinity};
  for (const double y : ends)
    for (const double x : ends) {
      INFO("atan2(" << y << ", " << x << ")");
      CHECK(bitsOf(portable::atan2(y, x)) == bitsOf(std::atan2(y, x)));
    }
  CHECK(std::isnan(portable::atan2(kNan, 1.0)));
}

TEST_CASE("portable functions have the same bits everywhere", "[math]") {
  // Hash of results over their ranges; every compiler and machine must get the same.
  std::uint64_t hash = 14695981039346656037u;
  const auto add = [&](double x) { hash = (hash ^ bitsOf(x)) * 1099511628211u; };
  std::mt19937_64 random(11);
  for (int i = 0; i < 20000; ++i) {
    const auto next = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const double a = 7 * next(), b = next() - 0.5, c = next();
    for (const double x : {portable::sin(a), portable::cos(a), portable::log(a),
                           portable::exp(10 * b), portable::atan2(b, c), portable::hypot(a, b, c)})
      add(x);
  }
  CHECK(hash == 0xa2d91e3110ebdf92u);
}
