#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace abflat {

/// A box in uv.
struct UvBox {
  std::array<double, 2> low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};

  void add(const double* uv) {
    for (std::size_t d = 0; d < 2; ++d) {
      low[d] = std::min(low[d], uv[d]);
      high[d] = std::max(high[d], uv[d]);
    }
  }
  bool meets(const UvBox& o) const {
    return low[0] <= o.high[0] && o.low[0] <= high[0] && low[1] <= o.high[1] && o.low[1] <= high[1];
  }
  bool operator==(const UvBox& o) const { return low == o.low && high == o.high; }
};

/// Triangles in uv, island by island.
struct IslandTriangles {
  std::vector<double> uv;            ///< 6 coordinates per triangle
  std::vector<std::uint32_t> begin;  ///< first triangle of each island, then their number

  std::uint32_t islands() const { return static_cast<std::uint32_t>(begin.size() - 1); }
  const double* of(std::uint32_t island) const {
    return uv.data() + 6 * std::size_t{begin[island]};
  }
  std::size_t count(std::uint32_t island) const { return begin[island + 1] - begin[island]; }
  UvBox box(std::uint32_t island) const {
    UvBox out;
    for (const double *p = of(island), *end = of(island + 1); p != end; p += 2) out.add(p);
    return out;
  }
};

/// Twice the area of a triangle, negative if it runs clockwise.
inline double doubleArea(const double* t) {
  return (t[2] - t[0]) * (t[5] - t[1]) - (t[4] - t[0]) * (t[3] - t[1]);
}

}  // namespace abflat
