#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "check/stacked_charts.h"

namespace abflat {

/// Triangles with texcoords, as the reader of a file gets them.
struct WrittenAtlas {
  const std::vector<double>& uv;                ///< 2 per texcoord
  const std::vector<std::uint32_t>& triangles;  ///< 3 texcoords each; two equal ones cover nothing
  const std::vector<std::uint32_t>& chartOf;    ///< per triangle
  std::function<bool(std::size_t)> hasArea;     ///< whether a triangle has area on the surface
  std::vector<std::uint8_t> isLeftOut;          ///< per chart: already known to be wrong
  std::vector<std::uint8_t> mayTouch;  ///< per chart: may share boundary with others that may
  std::uint32_t tiles = 1;             ///< number of unit squares, ten in a row
  double lowestV = 0;                  ///< of the first row of tiles
  /// Per chart: what findStackedCharts has found. Empty: no chart may lie on another.
  std::vector<StackedChart> stacked = {};
};

constexpr std::uint32_t kNoOther = 0xffffffff;

/// What is wrong with a chart.
struct ChartDefect {
  enum Kind { Flipped, Outside, Overlaps };
  std::uint32_t chart = 0;
  Kind kind = Flipped;
  std::size_t triangles = 0;       ///< flipped or without area
  std::uint32_t other = kNoOther;  ///< the overlapped one; itself if it overlaps or touches itself
};

/// Defects by chart; empty if the map is injective as written: every triangle is positively
/// oriented, or has no area if it has none on the surface; every chart lies within one tile; no two
/// triangles overlap; and no two charts touch unless both may. Stacked charts count as one, and a
/// mirrored one of them as if it were not. Decided exactly from the numbers alone, in O(n log n)
/// except for charts that may touch.
std::vector<ChartDefect> checkAtlas(const WrittenAtlas& atlas);

}  // namespace abflat
