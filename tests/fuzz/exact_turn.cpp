#include "exact_turn.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace abflat::fuzz {
namespace {

constexpr int kLimbBits = 32;
constexpr int kLeastExponent = 2 * (-1074);  ///< of a product of two doubles
constexpr std::size_t kLimbs = (2 * 1024 - kLeastExponent) / kLimbBits + 4;

/// Whole multiples of the least product, in limbs that carry late.
class Sum {
 public:
  void addProduct(double x, double y, int sign) {
    if (x == 0 || y == 0) return;
    int ex = 0, ey = 0;
    const auto mx = static_cast<std::int64_t>(std::ldexp(std::frexp(std::fabs(x), &ex), 53));
    const auto my = static_cast<std::int64_t>(std::ldexp(std::frexp(std::fabs(y), &ey), 53));
    if (std::signbit(x) != std::signbit(y)) sign = -sign;
    __extension__ using Wide = unsigned __int128;
    // Subnormal numbers have trailing zeros in their mantissas, so an exponent below the least one
    // loses nothing.
    Wide product = static_cast<Wide>(mx) * static_cast<Wide>(my);
    int shift = ex + ey - 106 - kLeastExponent;
    if (shift < 0) {
      product >>= -shift;
      shift = 0;
    }
    std::size_t limb = static_cast<std::size_t>(shift) / kLimbBits;
    const int offset = shift % kLimbBits;
    // 106 + 31 bits: the lowest limb first, so that the rest fits.
    add(limb++, static_cast<std::uint64_t>(product << offset & 0xffffffffu), sign);
    for (product >>= kLimbBits - offset; product != 0; product >>= kLimbBits)
      add(limb++, static_cast<std::uint64_t>(product & 0xffffffffu), sign);
  }

  int sign() {
    for (std::size_t i = 0; i + 1 < kLimbs; ++i) {
      const std::int64_t carry = limbs_[i] >> kLimbBits;  // rounds down, for negative ones too
      limbs_[i] -= carry * (std::int64_t{1} << kLimbBits);
      limbs_[i + 1] += carry;
    }
    if (limbs_.back() < 0) return -1;
    for (const std::int64_t limb : limbs_)
      if (limb != 0) return 1;
    return 0;
  }

 private:
  void add(std::size_t limb, std::uint64_t value, int sign) {
    limbs_[limb] += sign * static_cast<std::int64_t>(value);
  }

  std::array<std::int64_t, kLimbs> limbs_{};
};

}  // namespace

int exactTurn(const double* a, const double* b, const double* c) {
  Sum sum;
  const double* points[] = {a, b, c};
  for (int i = 0; i < 3; ++i) {
    const double *p = points[i], *q = points[(i + 1) % 3];
    sum.addProduct(p[0], q[1], 1);
    sum.addProduct(p[1], q[0], -1);
  }
  return sum.sign();
}

}  // namespace abflat::fuzz
