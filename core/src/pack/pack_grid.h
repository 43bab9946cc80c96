#pragma once

#include "pack/cover.h"
#include "pack/pack.h"
#include "pack/pose.h"

namespace abflat {

/// The cells of a tile that shapes are placed on. Lengths are in texels.
struct PackGrid {
  AtlasSize resolution;
  int padding = 0;
  int margin = 0;
  int cell = 1;        ///< side of a cell
  double slack = 0;    ///< covers the effect of rounding on coordinates
  bool snaps = false;  ///< some poses do

  int columns() const { return (resolution.width - 2 * margin) / cell; }
  int rows() const { return (resolution.height - 2 * margin) / cell; }
};

/// Of cells, along the shorter side of a tile.
constexpr int kLeastRows = 16;

/// Makes cells as large as possible without wasting room: they have to be small compared with the
/// shapes.
PackGrid makePackGrid(const PackOptions& options, std::size_t shapes);

/// How many cells a length takes.
double cellsOf(const PackGrid& grid, double texels);

/// Texels per unit along u and v. Where sides lie on borders of texels the shape is stretched, or
/// compressed, to the nearest whole number of texels.
PlanePoint texelScale(const PackGrid& grid, const Pose& pose, double texelsPerUnit);

/// At most this longer is a side that lies on borders of texels.
constexpr double kMostSnapped = 0.5;
/// At least this share of its length is left.
constexpr double kLeastSnapped = 0.75;

/// Left and lower margins of a shape in its first cell, in texels. If quarter turns share the
/// cells, the rest of the last cell is added to them.
PlanePoint margins(const PackGrid& grid, const Pose& pose, double texelsPerUnit);

/// The texel position of a shape's origin (rotated, in texels) if its footprint begins at the given
/// cell.
PlanePoint texelOrigin(const PackGrid& grid, const Pose& pose, double texelsPerUnit, int cellX,
                       int cellY);

/// Rasterizes shapes to cells.
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
