#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "mesh/ids.h"

namespace abflat {

inline std::uint64_t mixedBits(std::uint64_t a, std::uint64_t b) {
  std::uint64_t x = (a ^ (b + 0x9e3779b97f4a7c15u + (a << 6) + (a >> 2))) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 29) * 0x94d049bb133111ebu;
  return x ^ x >> 32;
}

/// A number per corner that tells what the surface looks like from there, in any numbering: each
/// round looks one triangle farther. `now`: what a corner looks like on its own; `beat` is called
/// once a round.
template <class Corner, class Beat>
IdVector<Corner, std::uint64_t> cornerColors(IdVector<Corner, std::uint64_t> now,
                                             const IdVector<Corner, Corner>& twin,
                                             std::size_t rounds, const Beat& beat) {
  IdVector<Corner, std::uint64_t> next(now.size());
  for (std::size_t k = 0; k < rounds; ++k) {
    for (const Corner h : now.ids()) {
      const Corner o = twin[h];
      next[h] = mixedBits(mixedBits(now[h], now[nextCorner(h)]), o.exists() ? now[o] : 0);
    }
    std::swap(now, next);
    beat();
  }
  return now;
}

}  // namespace abflat
