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
    const PackItem& item = items_[i];
    int top = tile.height() + 1;
    for (std::uint32_t p = 0; p < item.poses.size(); ++p) {
      const Pose& pose = item.poses[p];
      const double width = cellsOf(pose.width), height = cellsOf(pose.height);
      if (width > tile.width() || height > tile.height()) continue;
      int& begin = hints_[hintKey(width, height, item.area)];
      const int end = top - static_cast<int>(height);
      if (begin >= end) continue;
      rasterise(item, pose, 0, cover_, moved_, bits_);
      footprint_.set(bits_);
      const Cell cell = tile.find(footprint_, begin, end);
      begin = std::max(begin, cell.isFound() ? cell.y : end);
      if (!cell.isFound()) continue;
      top = cell.y + footprint_.height;
      spot.pose = p;
      spot.cell = cell;
    }
    return top <= tile.height();
  }

  std::size_t hintKey(double width, double height, double area) {
    static const double kW = getenv("HW") ? atof(getenv("HW")) : 2, kA = getenv("HA") ? atof(getenv("HA")) : 2;
    const double s = options_.texelsPerUnit / grid_.cell;
    auto q = [](double x, double steps) { return static_cast<std::size_t>(steps * std::log2(x + 1)); };
    return (q(width, kW) * 100 + q(height, kW)) * 100 + q(area * s * s, kA);
  }

  void take(std::uint32_t i, const Spot& spot) {
    rasterise(items_[i], items_[i].poses[spot.pose], grid_.padding, cover_, moved_, bits_);
    const int shift = grid_.padding > 0 ? shiftOf(grid_.padding) : 0;
    tiles_[spot.tile].take(bits_, spot.cell.x - shift, spot.cell.y - shift);
  }

  const std::vector<PackItem>& items_;
  const PackGrid& grid_;
  const PlaceOptions& options_;
  Footprint footprint_;
  std::vector<FreeMap> tiles_;
  std::vector<int> hints_ = std::vector<int>(1000000);
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
