#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace abflat {

/// Triangles with texcoords, as a reader of the file has them.
struct WrittenAtlas {
  const std::vector<double>& uv;                ///< 2 per texcoord
  const std::vector<std::uint32_t>& triangles;  ///< 3 texcoords each; those with two equal ones
                                                ///< cover nothing
  const std::vector<std::uint32_t>& chartOf;    ///< per triangle
  std::function<bool(std::size_t)> hasArea;     ///< of a triangle, on the surface
  std::vector<std::uint8_t> isLeftOut;          ///< per chart: known to be wrong by itself
  std::vector<std::uint8_t> mayTouch;           ///< per chart: it may have boundary in common with
                                                ///< others that may
  std::uint32_t tiles = 1;                      ///< unit squares, ten in a row
  double lowestV = 0;                           ///< of the first row of tiles
};

constexpr std::uint32_t kNoOther = 0xffffffff;

/// What is wrong with a chart.
struct ChartDefect {
  enum Kind { Flipped, Outside, Overlaps };
  std::uint32_t chart = 0;
  Kind kind = Flipped;
  std::size_t triangles = 0;       ///< flipped or without area
  std::uint32_t other = kNoOther;  ///< overlapped; the chart itself where it overlaps or touches
                                   ///< itself
};

/// By charts, nothing when the map is injective as it is written: every triangle is positively
/// oriented, or without area where it has none on the surface; every chart lies within one tile; no
/// two triangles overlap, and no two charts touch unless some may. Decided exactly from the numbers
/// alone, in n log n but for charts that may touch.
std::vector<ChartDefect> checkAtlas(const WrittenAtlas& atlas);

}  // namespace abflat
