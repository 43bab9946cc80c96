#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace abflat {

/// For each corner, the first corner of the same vertex that is equivalent to it. `isLess` orders
/// corners; two corners that it does not order are equivalent. O(n log n), however many corners a
/// vertex has.
template <class IsLess>
std::vector<std::uint32_t> firstAlike(std::size_t vertexCount,
                                      const std::vector<std::uint32_t>& vertexOfCorner,
                                      const IsLess& isLess) {
  std::vector<std::uint32_t> begin(vertexCount + 1, 0);
  for (const std::uint32_t v : vertexOfCorner) ++begin[v + 1];
  for (std::size_t v = 0; v < vertexCount; ++v) begin[v + 1] += begin[v];
  std::vector<std::uint32_t> fill(begin.begin(), begin.end() - 1), order(vertexOfCorner.size());
  for (std::uint32_t c = 0; c < vertexOfCorner.size(); ++c) order[fill[vertexOfCorner[c]]++] = c;
  std::vector<std::uint32_t> first(vertexOfCorner.size());
  for (std::size_t v = 0; v < vertexCount; ++v) {
    const auto own = order.begin() + begin[v], end = order.begin() + begin[v + 1];
    std::sort(own, end, [&](std::uint32_t a, std::uint32_t b) {
      return isLess(a, b) || (a < b && !isLess(b, a));
    });
    for (auto c = own; c != end; ++c)
      first[*c] = c == own || isLess(*(c - 1), *c) ? *c : first[*(c - 1)];
  }
  return first;
}

}  // namespace abflat
