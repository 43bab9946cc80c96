#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "pack/cover.h"
#include "pack/footprint.h"
#include "pack/free_map.h"
#include "pack/pose.h"
#include "parallel.h"

namespace abflat {

/// A shape as the placing needs it.
struct PackItem {
  Loops loops;
  std::vector<Pose> poses;
  double area = 0;
  double size = 0;  ///< larger ones are placed earlier
};

/// The grid that shapes are placed on. Lengths are in texels.
struct PackGrid {
  int resolution = 0;
  int padding = 0;
  int border = 0;
  int cell = 1;      ///< side of a cell
  double slack = 0;  ///< covers what rounding does to coordinates

  int cells() const { return (resolution - 2 * border) / cell; }
};

struct Spot {
  std::uint32_t tile = 0, pose = 0;
  Cell cell;
};

enum class Fit { All, TooMany, Cancelled };

struct PlaceOptions {
  double texelsPerUnit = 0;
  std::uint32_t mostTiles = 1;
  ThreadPool* pool = nullptr;
  std::function<bool(std::size_t placed)> onPlaced;
};

struct Placed {
  Fit fit = Fit::All;
  std::vector<Spot> spots;  ///< as many as items
  std::uint32_t tiles = 0;
  std::uint32_t missing = 0;  ///< the first item that found no place, unless all did
};

/// Items in the given order, each at the place with the lowest top among all its poses, in the
/// first tile that has one.
Placed place(const std::vector<PackItem>& items, const std::vector<std::uint32_t>& order,
             const PackGrid& grid, const PlaceOptions& options);

/// Where the coordinates of a shape end up, in texels.
PlanePoint texelOrigin(const PackGrid& grid, const Pose& pose, const Spot& spot,
                       double texelsPerUnit);

}  // namespace abflat
