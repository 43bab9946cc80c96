#pragma once

#include <cstdint>
#include <cstring>

namespace abflat {

inline std::uint64_t bitsOf(double x) {
  std::uint64_t out = 0;
  std::memcpy(&out, &x, sizeof out);
  return out;
}

inline double doubleOf(std::uint64_t bits) {
  double out = 0;
  std::memcpy(&out, &bits, sizeof out);
  return out;
}

}  // namespace abflat
