#pragma once

#include <cstdint>

namespace abflat {

/// For a word that is not 0.
inline int lowestBit(std::uint64_t word) { return __builtin_ctzll(word); }

inline int highestBit(std::uint64_t word) { return 63 - __builtin_clzll(word); }

inline int countBits(std::uint64_t word) { return __builtin_popcountll(word); }

/// For a number above 0.
inline int floorLog2(std::uint32_t x) { return 31 - __builtin_clz(x); }

/// The 64 bits of a row starting with bit `at`; reads up to one word past their end.
inline std::uint64_t bitsFrom(const std::uint64_t* row, int at) {
  const int word = at >> 6, shift = at & 63;
  return row[word] >> shift | row[word + 1] << 1 << (63 - shift);
}

}  // namespace abflat
