#pragma once

#include "pack/cover.h"
#include "pack/pose.h"

namespace abflat {

/// The cells of a tile that shapes are placed on. Lengths are in texels.
struct PackGrid {
  int resolution = 0;
  int padding = 0;
  int border = 0;
  int cell = 1;      ///< side of a cell
  double slack = 0;  ///< covers what rounding does to coordinates

  int cells() const { return (resolution - 2 * border) / cell; }
};

/// Cells are as large as they can be without costing room: they have to be small beside the shapes.
PackGrid makePackGrid(int resolution, int padding, std::size_t shapes);

/// Cells that a length takes.
double cellsOf(const PackGrid& grid, double texels);

/// Margins of a shape at the left and below in its first cell, in texels. Cells that are shared by
/// quarter turns have what is left of the last cell there as well.
PlanePoint margins(const PackGrid& grid, const Pose& pose, double texelsPerUnit);

/// Where coordinates of a shape (rotated, in texels) have their origin when its footprint begins at
/// the given cell.
PlanePoint texelOrigin(const PackGrid& grid, const Pose& pose, double texelsPerUnit, int cellX,
                       int cellY);

/// Turns shapes to cells.
class PackRaster {
 public:
  explicit PackRaster(const PackGrid& grid) : grid_(grid) {}

  /// The cells that a shape touches. Cell (0, 0) is where it begins.
  const BitGrid& touched(const Loops& loops, const Pose& pose, double texelsPerUnit) {
    return raster(loops, pose, texelsPerUnit, 0);
  }
  /// The cells that others must not touch. Cell (shift, shift) is where the shape begins.
  const BitGrid& taken(const Loops& loops, const Pose& pose, double texelsPerUnit) {
    return raster(loops, pose, texelsPerUnit, grid_.padding);
  }
  int shift() const { return grid_.padding > 0 ? (grid_.padding - 1) / grid_.cell + 1 : 0; }

  /// The same for a shape with coordinates in [0, 1] of a tile: all cells of the tile.
  const BitGrid& takenInTile(const Loops& loops, double originX, double originY);

 private:
  const BitGrid& raster(const Loops& loops, const Pose& pose, double texelsPerUnit, int padding);

  PackGrid grid_;
  Cover cover_;
  Loops moved_;
  BitGrid bits_;
};

}  // namespace abflat
