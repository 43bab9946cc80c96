#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/ids.h"

namespace abflat {

/// Walks from one corner on over all triangles that edges join to it, and appends the corner that
/// each is entered by. The order depends on nothing but that corner.
template <class Corner, class Triangle>
void walkTriangles(Corner start, const IdVector<Corner, Corner>& twin,
                   IdVector<Triangle, std::uint8_t>& isSeen, std::vector<Corner>& out) {
  std::size_t i = out.size();
  out.push_back(start);
  isSeen[triangleOf(start)] = 1;
  for (; i < out.size(); ++i)
    for (Corner h : {out[i], nextCorner(out[i]), prevCorner(out[i])}) {
      h = twin[h];
      if (!h.exists() || isSeen[triangleOf(h)]) continue;
      isSeen[triangleOf(h)] = 1;
      out.push_back(h);
    }
}

}  // namespace abflat
