#include "pack/pack_grid.h"

#include <algorithm>
#include <cmath>

namespace abflat {
namespace {

/// Rounding coordinates up to 16 (ten tiles in a row) to single precision moves them by no more
/// than this share of a tile.
constexpr double kSlackShare = 0x1p-20;

/// Left and lower margin of a shape in its first cell, in slacks. There is another one at the top.
constexpr double kMargin = 2;

int divideUp(double a, int b) { return static_cast<int>(std::ceil(a / b)); }

}  // namespace

PackGrid makePackGrid(const PackOptions& options, std::size_t shapes) {
  constexpr double kCellsOfShape = 64;
  constexpr double kLeastCellsOfShape = 8;
  constexpr int kMostCells = 2048, kLeastCells = 512;
  const double resolution = options.resolution.meanSide();
  PackGrid grid;
  grid.resolution = options.resolution;
  grid.padding = options.padding;
  grid.margin = marginOf(options);
  grid.slack = options.resolution.longer() * kSlackShare;
  grid.snaps = options.snapToTexels;
  const double side = resolution / std::sqrt(static_cast<double>(std::max<std::size_t>(shapes, 1)));
  const int cell = std::clamp(static_cast<int>(side / kCellsOfShape),
                              divideUp(resolution, kMostCells), divideUp(resolution, kLeastCells));
  const int shorter = options.resolution.shorter();
  const int most = std::min({static_cast<int>(side / kLeastCellsOfShape), shorter / kLeastRows,
                             shorter - 2 * grid.margin});
  grid.cell = std::max(std::min(cell, most), 1);
  return grid;
}

double cellsOf(const PackGrid& grid, double texels) {
  return std::floor((texels + (kMargin + 1) * grid.slack) / grid.cell) + 1;
}

PlanePoint texelScale(const PackGrid& grid, const Pose& pose, double texelsPerUnit) {
  if (!pose.snaps) return {texelsPerUnit, texelsPerUnit};
  const auto along = [&](double length) {
    constexpr double kLeast = 2;
    const double texels = std::round(length * texelsPerUnit);
    // Margins at both ends keep it off the texels beside it.
    return texels < kLeast ? texelsPerUnit : (texels - 2 * kMargin * grid.slack) / length;
  };
  return {along(pose.width), along(pose.height)};
}

PlanePoint margins(const PackGrid& grid, const Pose& pose, double texelsPerUnit) {
  const double first = kMargin * grid.slack;
  const PlanePoint scale = texelScale(grid, pose, texelsPerUnit);
  const auto last = [&](double texels) {
    return cellsOf(grid, texels) * grid.cell - texels - first;
  };
  const bool isTurnedX = pose.quarter == 1 || pose.quarter == 2;
  return {isTurnedX ? last(pose.width * scale.x) : first,
          pose.quarter >= 2 ? last(pose.height * scale.y) : first};
}

PlanePoint texelOrigin(const PackGrid& grid, const Pose& pose, double texelsPerUnit, int cellX,
                       int cellY) {
  const PlanePoint margin = margins(grid, pose, texelsPerUnit);
  const PlanePoint scale = texelScale(grid, pose, texelsPerUnit);
  return {cellX * grid.cell + grid.margin + margin.x - pose.minX * scale.x,
          cellY * grid.cell + grid.margin + margin.y - pose.minY * scale.y};
}

const BitGrid& PackRaster::raster(const Loops& loops, const Pose& pose, double texelsPerUnit,
                                  int padding) {
  const double cell = grid_.cell;
  const PlanePoint texels = texelScale(grid_, pose, texelsPerUnit);
  const PlanePoint scale{texels.x / cell, texels.y / cell};
  const int begin = padding > 0 ? shift() : 0;
  const PlanePoint margin = margins(grid_, pose, texelsPerUnit);
  const PlanePoint from{margin.x / cell + begin, margin.y / cell + begin};
  moved_.ends = loops.ends;
  moved_.isGroup = loops.isGroup;
  moved_.points.resize(loops.points.size());
  for (std::size_t k = 0; k < moved_.points.size(); ++k) {
    const PlanePoint p = pose.rotated(loops.points[k]);
    moved_.points[k] = {(p.x - pose.minX) * scale.x + from.x, (p.y - pose.minY) * scale.y + from.y};
  }
  const auto cells = [&](double length, double before) {
    const double more = before - kMargin * grid_.slack;
    return begin + static_cast<int>(cellsOf(grid_, length + (padding + more)));
  };
  bits_.reset(cells(pose.width * texels.x, margin.x), cells(pose.height * texels.y, margin.y));
  // Boxes of half-size `slack + padding` around the points of an edge touch exactly the texels
  // within `padding` texels of one that the edge touches.
  cover_.cover(moved_, (grid_.slack + padding) / cell, bits_);
  return bits_;
}

const BitGrid& PackRaster::takenInTile(const Loops& loops, double originX, double originY) {
  const double cell = grid_.cell;
  moved_.ends = loops.ends;
  moved_.isGroup = loops.isGroup;
  moved_.points.clear();
  for (const PlanePoint& p : loops.points)
    moved_.points.push_back({((p.x - originX) * grid_.resolution.width - grid_.margin) / cell,
                             ((p.y - originY) * grid_.resolution.height - grid_.margin) / cell});
  bits_.reset(grid_.columns(), grid_.rows());
  cover_.cover(moved_, (grid_.slack + grid_.padding) / cell, bits_);
  return bits_;
}

}  // namespace abflat
