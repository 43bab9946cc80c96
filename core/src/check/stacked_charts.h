#pragma once

#include <cstdint>
#include <vector>

namespace abflat {

constexpr std::uint32_t kOnNone = 0xffffffff;

/// Which chart lies on which.
struct StackedChart {
  std::uint32_t on = kOnNone;  ///< a chart that lies on none
  bool isMirrored = false;     ///< its triangles run clockwise
};

/// Finds charts with the same outline, bit by bit. Each lies on the first of them that runs
/// counter-clockwise. A chart that runs clockwise does so only if `mayMirror`; otherwise it lies on
/// none. `triangles` and `chartOf` as in WrittenAtlas.
std::vector<StackedChart> findStackedCharts(const std::vector<double>& uv,
                                            const std::vector<std::uint32_t>& triangles,
                                            const std::vector<std::uint32_t>& chartOf,
                                            std::size_t charts, bool mayMirror);

}  // namespace abflat
