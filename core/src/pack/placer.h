#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "pack/cover.h"
#include "pack/footprint.h"
#include "pack/free_map.h"
#include "pack/pack_grid.h"

namespace abflat {

/// A shape as the placing needs it.
struct PackItem {
  Loops loops;
  std::vector<Pose> poses;  ///< a full turn in equal steps; the first is that of the least box
  Mass mass;
};

/// How placing goes about it.
struct PlaceStrategy {
  std::vector<std::uint32_t> order;  ///< of the items
  int angles = 4;                    ///< of the poses, as many are tried
};

struct Spot {
  std::uint32_t tile = 0, pose = 0;
  Cell cell;
};

enum class Fit { All, TooMany, Cancelled };

/// Items as cells at one scale, made when they are needed and kept from one try to the next.
struct Rasters {
  using Key = std::pair<std::uint32_t, std::uint32_t>;  ///< item and pose
  double texelsPerUnit = 0;
  std::map<Key, Footprint> touched;
  std::map<Key, BitGrid> taken;
};

struct PlaceOptions {
  double texelsPerUnit = 0;
  std::uint32_t mostTiles = 1;
  std::function<bool(std::size_t placed)> onPlaced;  ///< false cancels
  Rasters* rasters = nullptr;  ///< of the same items and grid; null: nothing is kept
};

struct Placed {
  Fit fit = Fit::All;
  std::vector<Spot> spots;  ///< as many as items
  std::uint32_t tiles = 0;
  std::uint32_t missing = 0;  ///< the first item that found no place, unless all did
};

/// Items in order, each in the pose and at the place where its mass is lowest, in the first tile
/// that has one. `start`: tiles that are partly taken; more are added behind them.
Placed place(const std::vector<PackItem>& items, const PlaceStrategy& strategy,
             const PackGrid& grid, const std::vector<FreeMap>& start, const PlaceOptions& options);

}  // namespace abflat
