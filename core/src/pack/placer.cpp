#include "pack/placer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace abflat {
namespace {

/// Twice the logarithm to base 2, rounded down: sizes within a factor of 1.4 are alike.
std::size_t sizeClass(double x) {
  int exponent;
  const double mantissa = std::frexp(x + 1, &exponent);
  return static_cast<std::size_t>(2 * (exponent - 1) + (mantissa >= 0.70710678118654752 ? 1 : 0));
}

/// Remembers for shapes of about the same size and filling below which row none of them fits any
/// more, so that the thousandth does not begin its search at the bottom.
class SearchBegins {
 public:
  int& of(double width, double height, double area) {
    const std::size_t key = (sizeClass(width) * kClasses + sizeClass(height)) * 2 * kClasses +
                            std::min(sizeClass(area), 2 * kClasses - 1);
    return begins_[key];
  }

 private:
  static constexpr std::size_t kClasses = 24;  // sides up to 2^12 cells
  std::vector<int> begins_ = std::vector<int>(kClasses * kClasses * 2 * kClasses);
};

class Placer {
 public:
  Placer(const std::vector<PackItem>& items, const PackGrid& grid,
         const std::vector<FreeMap>& start, const PlaceOptions& options)
      : items_(items),
        grid_(grid),
        options_(options),
        tiles_(start),
        begins_(start.size()),
        raster_(grid) {}

  Placed run(const std::vector<std::uint32_t>& order) {
    Placed out;
    out.spots.resize(items_.size());
    std::size_t count = 0;
    for (const std::uint32_t i : order) {
      if (options_.onPlaced && !options_.onPlaced(count)) {
        out.fit = Fit::Cancelled;
        return out;
      }
      if (!items_[i].loops.points.empty() && !placeItem(i, out.spots[i])) {
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
  bool placeItem(std::uint32_t i, Spot& spot) {
    for (std::uint32_t t = 0; t < options_.mostTiles; ++t) {
      const bool isNew = t == tiles_.size();
      if (isNew) {
        tiles_.emplace_back(grid_.cells(), grid_.cells());
        begins_.emplace_back();
      }
      if (findIn(t, i, spot)) {
        take(i, spot);
        return true;
      }
      if (isNew) return false;
    }
    return false;
  }

  bool findIn(std::uint32_t t, std::uint32_t i, Spot& spot) {
    FreeMap& tile = tiles_[t];
    const PackItem& item = items_[i];
    const double scale = options_.texelsPerUnit;
    const double area = item.area * scale * scale / grid_.cell / grid_.cell;
    int top = tile.height() + 1;
    for (std::uint32_t p = 0; p < item.poses.size(); ++p) {
      const Pose& pose = item.poses[p];
      const double width = cellsOf(grid_, pose.width * scale);
      const double height = cellsOf(grid_, pose.height * scale);
      if (width > tile.width() || height > tile.height()) continue;
      int& begin = begins_[t].of(width, height, area);
      const int end = top - static_cast<int>(height);
      if (begin >= end) continue;
      footprint_.set(raster_.touched(item.loops, pose, scale));
      const Cell cell = tile.find(footprint_, begin, end);
      begin = std::max(begin, cell.isFound() ? cell.y : end);
      if (!cell.isFound()) continue;
      top = cell.y + footprint_.height;
      spot = {t, p, cell};
    }
    return top <= tile.height();
  }

  void take(std::uint32_t i, const Spot& spot) {
    const BitGrid& taken =
        raster_.taken(items_[i].loops, items_[i].poses[spot.pose], options_.texelsPerUnit);
    tiles_[spot.tile].take(taken, spot.cell.x - raster_.shift(), spot.cell.y - raster_.shift());
  }

  const std::vector<PackItem>& items_;
  const PackGrid& grid_;
  const PlaceOptions& options_;
  std::vector<FreeMap> tiles_;
  std::vector<SearchBegins> begins_;
  PackRaster raster_;
  Footprint footprint_;
};

}  // namespace

Placed place(const std::vector<PackItem>& items, const std::vector<std::uint32_t>& order,
             const PackGrid& grid, const std::vector<FreeMap>& start, const PlaceOptions& options) {
  return Placer(items, grid, start, options).run(order);
}

}  // namespace abflat
