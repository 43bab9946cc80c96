#include "pack/placer.h"

#include <algorithm>
#include <cmath>

namespace abflat {
namespace {

/// Left and lower margin of a shape in its first cell, in slacks.
constexpr double kMargin = 2;

class Placer {
 public:
  Placer(const std::vector<PackItem>& items, const PackGrid& grid, const PlaceOptions& options)
      : items_(items), grid_(grid), options_(options) {}

  Placed run(const std::vector<std::uint32_t>& order) {
    Placed out;
    out.spots.resize(items_.size());
    rasterise();
    std::size_t count = 0;
    for (const std::uint32_t i : order) {
      if (options_.onPlaced && !options_.onPlaced(count)) {
        out.fit = Fit::Cancelled;
        return out;
      }
      if (!placeItem(i, out.spots[i])) {
        out.fit = Fit::TooMany;
        out.missing = i;
        return out;
      }
      ++count;
    }
    out.tiles = static_cast<std::uint32_t>(tiles_.size());
    return out;
  }

 private:
  void rasterise() {
    footprints_.resize(items_.size());
    parallelRanges(options_.pool, items_.size(), 64, [this](std::size_t begin, std::size_t end) {
      Cover cover;
      BitGrid bits;
      Loops moved;
      for (std::size_t i = begin; i < end; ++i) {
        footprints_[i].resize(items_[i].poses.size());
        for (std::size_t p = 0; p < items_[i].poses.size(); ++p) {
          const Pose& pose = items_[i].poses[p];
          if (std::max(cellsOf(pose.width), cellsOf(pose.height)) > grid_.cells()) continue;
          rasterise(items_[i], pose, 0, cover, moved, bits);
          footprints_[i][p] = footprintOf(bits);
        }
      }
    });
  }

  double cellsOf(double length) const {
    return std::floor((length * options_.texelsPerUnit + 3 * grid_.slack) / grid_.cell) + 1;
  }

  /// Cells that padding may add on the lower side.
  int shiftOf(int padding) const { return (padding + grid_.cell) / grid_.cell; }

  void rasterise(const PackItem& item, const Pose& pose, int padding, Cover& cover, Loops& moved,
                 BitGrid& bits) const {
    const double scale = options_.texelsPerUnit, cell = grid_.cell;
    const int shift = padding > 0 ? shiftOf(padding) : 0;
    moved.ends = item.loops.ends;
    moved.points.resize(item.loops.points.size());
    for (std::size_t k = 0; k < moved.points.size(); ++k) {
      const PlanePoint p = pose.rotated(item.loops.points[k]);
      moved.points[k] = {((p.x - pose.minX) * scale + kMargin * grid_.slack) / cell + shift,
                         ((p.y - pose.minY) * scale + kMargin * grid_.slack) / cell + shift};
    }
    const double more = padding / cell;
    bits.reset(static_cast<int>(cellsOf(pose.width) + std::ceil(more)) + shift,
               static_cast<int>(cellsOf(pose.height) + std::ceil(more)) + shift);
    cover.cover(moved, grid_.slack / cell + more, bits);
  }

  bool placeItem(std::uint32_t i, Spot& spot) {
    for (std::uint32_t t = 0; t < options_.mostTiles; ++t) {
      if (t == tiles_.size()) tiles_.emplace_back(grid_.cells(), grid_.cells());
      if (findIn(tiles_[t], i, spot)) {
        spot.tile = t;
        take(i, spot);
        return true;
      }
    }
    return false;
  }

  bool findIn(FreeMap& tile, std::uint32_t i, Spot& spot) {
    const std::vector<Footprint>& poses = footprints_[i];
    int top = tile.height() + 1;
    for (std::uint32_t p = 0; p < poses.size(); ++p) {
      if (poses[p].runs.empty()) continue;
      const Cell cell = tile.find(poses[p], 0, top - poses[p].height);
      if (!cell.isFound()) continue;
      top = cell.y + poses[p].height;
      spot.pose = p;
      spot.cell = cell;
    }
    return top <= tile.height();
  }

  void take(std::uint32_t i, const Spot& spot) {
    rasterise(items_[i], items_[i].poses[spot.pose], grid_.padding, cover_, moved_, bits_);
    const int shift = grid_.padding > 0 ? shiftOf(grid_.padding) : 0;
    tiles_[spot.tile].take(bits_, spot.cell.x - shift, spot.cell.y - shift);
  }

  const std::vector<PackItem>& items_;
  const PackGrid& grid_;
  const PlaceOptions& options_;
  std::vector<std::vector<Footprint>> footprints_;
  std::vector<FreeMap> tiles_;
  Cover cover_;
  Loops moved_;
  BitGrid bits_;
};

}  // namespace

Placed place(const std::vector<PackItem>& items, const std::vector<std::uint32_t>& order,
             const PackGrid& grid, const PlaceOptions& options) {
  return Placer(items, grid, options).run(order);
}

PlanePoint texelOrigin(const PackGrid& grid, const Pose& pose, const Spot& spot,
                       double texelsPerUnit) {
  const double margin = grid.border + kMargin * grid.slack;
  return {spot.cell.x * grid.cell + margin - pose.minX * texelsPerUnit,
          spot.cell.y * grid.cell + margin - pose.minY * texelsPerUnit};
}

}  // namespace abflat
