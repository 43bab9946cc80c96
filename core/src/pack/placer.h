#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "pack/cover.h"
#include "pack/footprint.h"
#include "pack/free_map.h"
#include "pack/pack_grid.h"

namespace abflat {

/// A shape as the placing needs it.
struct PackItem {
  Loops loops;
  std::vector<Pose> poses;
  double area = 0;
  double size = 0;  ///< larger ones are placed earlier
};

struct Spot {
  std::uint32_t tile = 0, pose = 0;
  Cell cell;
};

enum class Fit { All, TooMany, Cancelled };

struct PlaceOptions {
  double texelsPerUnit = 0;
  std::uint32_t mostTiles = 1;
  std::function<bool(std::size_t placed)> onPlaced;  ///< false cancels
};

struct Placed {
  Fit fit = Fit::All;
  std::vector<Spot> spots;  ///< as many as items
  std::uint32_t tiles = 0;
  std::uint32_t missing = 0;  ///< the first item that found no place, unless all did
};

/// Items in the given order, each at the place with the lowest top among all its poses, in the
/// first tile that has one. `start`: tiles that are partly taken; more are added behind them.
Placed place(const std::vector<PackItem>& items, const std::vector<std::uint32_t>& order,
             const PackGrid& grid, const std::vector<FreeMap>& start, const PlaceOptions& options);

}  // namespace abflat
