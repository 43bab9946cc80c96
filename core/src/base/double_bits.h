#pragma once

#include <cstdint>
#include <cstring>

namespace abflat {

inline std::uint64_t bitsOf(double x) {
  std::uint64_t out = 0;
  std::memcpy(&out, &x, sizeof out);
  return out;
}

}  // namespace abflat
