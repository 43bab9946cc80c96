#include "exact/in_circle.h"

#include <array>
#include <cmath>
#include <random>

#include "catch.h"

using namespace abflat;

namespace {

using Point = std::array<long long, 2>;
__extension__ using Wide = __int128;

/// The determinant in integers; coordinates up to 2^28 fit into 128 bits.
int exactInCircle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto relative = [&](const Point& p, int i) { return static_cast<Wide>(p[i] - d[i]); };
  const auto lift = [&](const Point& p) {
    return relative(p, 0) * relative(p, 0) + relative(p, 1) * relative(p, 1);
  };
  const auto minor = [&](const Point& p, const Point& q) {
    return relative(p, 0) * relative(q, 1) - relative(p, 1) * relative(q, 0);
  };
  const Wide det = lift(a) * minor(b, c) + lift(b) * minor(c, a) + lift(c) * minor(a, b);
  return (det > 0) - (det < 0);
}

int inCircle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto real = [](const Point& p) {
    return std::array<double, 2>{static_cast<double>(p[0]), static_cast<double>(p[1])};
  };
  return abflat::inCircle(real(a).data(), real(b).data(), real(c).data(), real(d).data());
}

}  // namespace

TEST_CASE("in-circle agrees with integer arithmetic next to a circle") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> turn(0, 6.283185307179586);
  std::uniform_int_distribution<long long> centre(-(1ll << 26), 1ll << 26), nudge(-1, 1);
  int onCircle = 0;
  for (int n = 0; n < 20000; ++n) {
    const Point m{centre(random), centre(random)};
    const double radius = static_cast<double>(1ll << (n % 26));
    std::array<double, 4> angle;
    for (double& x : angle) x = turn(random);
    std::sort(angle.begin(), angle.end());
    std::array<Point, 4> p;
    for (std::size_t k = 0; k < 4; ++k)
      p[k] = {m[0] + std::llround(radius * std::cos(angle[k])),
              m[1] + std::llround(radius * std::sin(angle[k])) + nudge(random)};
    const int wanted = exactInCircle(p[0], p[1], p[2], p[3]);
    CHECK(inCircle(p[0], p[1], p[2], p[3]) == wanted);
    CHECK(inCircle(p[1], p[2], p[0], p[3]) == wanted);
    CHECK(inCircle(p[1], p[0], p[2], p[3]) == -wanted);
    onCircle += wanted == 0;
  }
  CHECK(onCircle > 0);
}

TEST_CASE("in-circle tells neighbouring doubles apart") {
  const double a[2] = {1, 0}, b[2] = {0, 1}, c[2] = {-1, 0};
  const double on[2] = {0, -1}, in[2] = {0, std::nextafter(-1.0, 0.0)},
               out[2] = {0, std::nextafter(-1.0, -2.0)};
  CHECK(abflat::inCircle(a, b, c, on) == 0);
  CHECK(abflat::inCircle(a, b, c, in) == 1);
  CHECK(abflat::inCircle(a, b, c, out) == -1);
}
