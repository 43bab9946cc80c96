#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace abflat {

/// Edges of the outlines of charts.
struct OutlineEdges {
  std::vector<double> ends;                  ///< 4 per edge: two points
  std::vector<std::uint32_t> chart;          ///< per edge
  std::vector<std::uint32_t> triangle = {};  ///< per edge, where that is known

  std::uint32_t count() const { return static_cast<std::uint32_t>(chart.size()); }
};

/// Where the outlines of two charts are nearest to each other.
struct ChartGap {
  std::array<std::uint32_t, 2> charts;  ///< the smaller number first
  std::array<std::uint32_t, 2> edges;   ///< one of each
  double distance = 0;                  ///< 0 where they touch or cross
};

/// The two charts that are nearest to each other; nothing if there is only one. Close to linear.
std::optional<ChartGap> leastGap(const OutlineEdges& edges);

/// All pairs of charts less than `reach` apart, by their numbers. Close to linear if few are near.
std::vector<ChartGap> gapsBelow(const OutlineEdges& edges, double reach);

}  // namespace abflat
