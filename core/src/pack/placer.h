#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "pack/cover.h"
#include "pack/footprint.h"
#include "pack/free_map.h"
#include "pack/pack_grid.h"

namespace abflat {

/// A shape as the placing needs it.
struct PackItem {
  Loops loops;
  Poses poses;  ///< the first is that of the least box
  Mass mass;
};

/// The longest side of the box of any pose.
double longestSide(const PackItem& item);
double longestSide(const std::vector<PackItem>& items);

/// Side of the least square that has room for each item in some pose.
double sideForAll(const std::vector<PackItem>& items);

/// How placing goes about it.
struct PlaceStrategy {
  std::vector<std::uint32_t> order;  ///< of the items
  int angles = 4;                    ///< of the poses, as many are tried
  std::vector<std::uint32_t> poses;  ///< per item: the only one that is tried; empty: any
};

struct Spot {
  std::uint32_t tile = 0, pose = 0;
  Cell cell;
};

enum class Fit { All, TooMany, Cancelled };

/// Remembers for shapes of about the same size and filling, and for each quarter turn, below which
/// row none of them fits any more, so that the thousandth does not begin its search at the bottom.
class SearchBegins {
 public:
  int& of(double width, double height, double area, std::size_t quarter);

 private:
  std::map<std::uint32_t, int> begins_;
};

/// What placing works with, kept from one try to the next: memory, and what is still true then.
struct PlaceSpace {
  template <typename Cells>
  struct AtScale {
    double texelsPerUnit = 0;
    Cells cells;
  };
  /// In each quarter turn from a pose.
  using Footprints = std::array<Footprint, 4>;
  /// Per item and pose, made when they are needed. Empty: they are not kept.
  std::vector<AtScale<Footprints>> touched;
  std::vector<AtScale<BitGrid>> taken;
  std::vector<FreeMap> tiles;
  std::vector<SearchBegins> begins;  ///< per tile

  void keepCells(const std::vector<PackItem>& items);
};

/// A tile on which items have been placed.
struct PlaceStart {
  FreeMap tile;
  SearchBegins begins;
};

struct PlaceOptions {
  double texelsPerUnit = 0;
  std::uint32_t mostTiles = 1;
  double mostMissing = -1;  ///< area of items that may stay without a place; negative: none may
  const PlaceStart* start = nullptr;                 ///< of the first tile; null: `taken` tells
  std::function<bool(std::size_t placed)> onPlaced;  ///< false cancels
};

struct Placed {
  Fit fit = Fit::All;
  std::vector<Spot> spots;  ///< as many as items
  std::uint32_t tiles = 0;
  double work = 0;            ///< rows of cells of all poses that were tried or taken
  int rows = 0;               ///< of the tiles that are used, counted from the bottom
  std::uint32_t missing = 0;  ///< the first item that found no place, unless all did
};

/// Items in order, each in the pose and at the place where its mass is lowest, in the first tile
/// that has one. `taken`: cells that are taken at first, per tile, or an empty grid; more tiles are
/// added behind them. `space`: new, or of earlier calls with the same items and grid.
Placed place(const std::vector<PackItem>& items, const PlaceStrategy& strategy,
             const PackGrid& grid, const std::vector<BitGrid>& taken, const PlaceOptions& options,
             PlaceSpace& space);

}  // namespace abflat
