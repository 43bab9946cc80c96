#pragma once

#include <cmath>

namespace abflat {

/// Keeps 21 bits of a measure: more than any decision needs, and so few that turning a mesh, or a
/// change of its unit, hardly ever changes one of them. What is equal stays equal.
inline double inFewBits(double x) {
  constexpr int kBits = 21;
  int exponent = 0;
  const double part = std::frexp(x, &exponent);
  return std::ldexp(std::floor(std::ldexp(part, kBits) + 0.5), exponent - kBits);
}

}  // namespace abflat
