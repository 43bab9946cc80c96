#pragma once

#include <cmath>
#include <cstdint>

#include "base/double_bits.h"

namespace abflat {

/// Keeps 21 bits of a measure: more than any decision needs, and so few that turning a mesh, or a
/// change of its unit, hardly ever changes one of them. What is equal stays equal.
inline double inFewBits(double x) {
  // Of the 53 bits, 32 go; halves round upwards.
  constexpr std::uint64_t kDropped = 0xffffffff, kHalf = 0x80000000;
  const std::uint64_t isNegative = std::signbit(x) ? 1 : 0;
  if (std::isnormal(x)) return doubleOf((bitsOf(x) + kHalf - isNegative) & ~kDropped);
  constexpr double kNormal = 0x1p60;
  return x == 0 ? 0 : std::isfinite(x) ? inFewBits(x * kNormal) / kNormal : x;
}

}  // namespace abflat
