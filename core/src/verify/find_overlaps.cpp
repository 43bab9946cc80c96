#include "verify/find_overlaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

#include "exact/overlap.h"

namespace abflat {
namespace {

bool coverSame(const UvBox& a, const UvBox& b, const AtlasSize& size) {
  constexpr double kHalfATexel = 0.5;
  const std::array<int, 2> texels = {size.width, size.height};
  for (std::size_t d = 0; d < 2; ++d)
    if (std::abs(a.low[d] - b.low[d]) * texels[d] > kHalfATexel ||
        std::abs(a.high[d] - b.high[d]) * texels[d] > kHalfATexel)
      return false;
  return true;
}

bool areAlike(double a, double b) {
  constexpr double kAlike = 0.01;
  return std::abs(a - b) <= kAlike * std::max(a, b);
}

}  // namespace

FoundOverlaps findOverlaps(const MappedTriangles& triangles,
                           const std::vector<std::uint32_t>& island, const LayoutMeasures& measures,
                           const AtlasSize& size) {
  const IslandTriangles& inUv = triangles.inUv;
  FoundOverlaps out;
  out.overlapping.assign(island.size(), 0);
  out.isOnAnother.assign(inUv.islands(), 0);
  std::map<std::array<std::uint32_t, 2>, IslandOverlap> found;
  const auto islandsOf = [&](std::uint32_t i, std::uint32_t k) -> std::array<std::uint32_t, 2> {
    return {std::min(island[i], island[k]), std::max(island[i], island[k])};
  };
  forOverlaps(
      inUv.uv,
      [&](std::uint32_t i, std::uint32_t k) {
        return out.overlapping[i] && out.overlapping[k] && found.count(islandsOf(i, k)) > 0;
      },
      [&](std::uint32_t i, std::uint32_t k) {
        out.overlapping[i] = out.overlapping[k] = 1;
        IslandOverlap pair{islandsOf(i, k), {i, k}};
        if (island[i] > island[k]) std::swap(pair.triangles[0], pair.triangles[1]);
        found.emplace(pair.islands, pair);
      });
  for (auto& [islands, pair] : found) {
    const auto [a, b] = islands;
    pair.isStacked = a != b && coverSame(inUv.box(a), inUv.box(b), size) &&
                     areAlike(measures.islands[a].area, measures.islands[b].area);
    if (pair.isStacked) out.isOnAnother[b] = 1;
    out.pairs.push_back(pair);
  }
  return out;
}

}  // namespace abflat
