#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "base/listener.h"
#include "pack/cover.h"
#include "pack/footprint.h"
#include "pack/free_map.h"
#include "pack/pack_grid.h"

namespace abflat {

/// A shape in the form that placing needs.
struct PackItem {
  Loops loops;
  Poses poses;  ///< the same number for each item; the first is level and upright, if any is
  Mass mass;
  bool isLevel = false;    ///< the first pose is better because straight edges lie along u and v
  bool isUpright = false;  ///< the first pose is better because it stands upright
};

/// The longest side of the box of any pose.
double longestSide(const PackItem& item);
double longestSide(const std::vector<PackItem>& items);

/// The largest scale at which a box of that size holds each item in some pose.
double scaleForAll(const std::vector<PackItem>& items, double width, double height);

/// How far a pose is from level and upright: 0 to 1.
double untidiness(const PackItem& item, std::size_t pose);

/// How items are placed.
struct PlaceStrategy {
  std::vector<std::uint32_t> order;  ///< of the items
  std::vector<std::uint32_t> turns;  ///< the poses to try
  /// A pose that is not level and upright is only taken where the item then lies lower by this many
  /// times the root of its area.
  double tidiness = 0;
  std::vector<std::uint32_t> poses;  ///< per item: the only pose to try; empty: all of `turns`
};

struct Spot {
  std::uint32_t tile = 0, pose = 0;
  Cell cell;
};

enum class Fit { All, TooMany, Cancelled };

/// Remembers, for shapes of similar size and fill and for each quarter turn, the row below which
/// none of them fits any more, so that the thousandth shape need not start its search at the
/// bottom.
class SearchBegins {
 public:
  int& of(double width, double height, double area, std::size_t quarter);

 private:
  std::map<std::uint32_t, int> begins_;
};

/// Work space of placing, kept from one try to the next: memory, and results that stay true.
struct PlaceSpace {
  template <typename Cells>
  struct AtScale {
    double texelsPerUnit = 0;
    Cells cells;
  };
  /// For each quarter turn from a pose.
  using Footprints = std::array<Footprint, 4>;
  /// Per item and pose, made on demand. Empty: not kept.
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
  bool isTileKept = false;  ///< as a start: it must serve any item, not only these
  const PlaceStart* start = nullptr;  ///< initial state of the first tile; null: use `taken`
  Listener listener;                  ///< told now and then how many items have been placed
};

struct Placed {
  Fit fit = Fit::All;
  std::vector<Spot> spots;  ///< one per item
  std::uint32_t tiles = 0;
  double work = 0;            ///< rows of cells, over all poses that were tried or taken
  int rows = 0;               ///< highest row used in the tiles, counted from the bottom
  std::uint32_t missing = 0;  ///< first item without a place, if there is one
};

/// Places items in order, each in the pose and place where its mass is lowest, in the first tile
/// that has room. `taken`: initially taken cells per tile, or an empty grid; more tiles are added
/// after these. `space`: new, or from earlier calls with the same items and grid.
Placed place(const std::vector<PackItem>& items, const PlaceStrategy& strategy,
             const PackGrid& grid, const std::vector<BitGrid>& taken, const PlaceOptions& options,
             PlaceSpace& space);

}  // namespace abflat
