#include "pack/placer.h"

#include <algorithm>
#include <cmath>

namespace abflat {
namespace {

/// Twice the logarithm to base 2, rounded down: sizes within a factor of 1.4 are alike.
std::size_t sizeClass(double x) {
  int exponent = 0;
  const bool isUpper = std::frexp(x + 1, &exponent) >= 0.70710678118654752;
  return 2 * static_cast<std::size_t>(exponent - 1) + (isUpper ? 1 : 0);
}

/// Rounding errors must not choose between poses that are alike.
double rounded(double cells) { return std::round(cells * 256) / 256; }

/// Remembers for shapes of about the same size and filling, and for each quarter turn, below which
/// row none of them fits any more, so that the thousandth does not begin its search at the bottom.
class SearchBegins {
 public:
  int& of(double width, double height, double area, std::size_t quarter) {
    const std::size_t filling = std::min(sizeClass(area), 2 * kClasses - 1);
    return begins_[((sizeClass(width) * kClasses + sizeClass(height)) * 2 * kClasses + filling) *
                       4 +
                   quarter];
  }

 private:
  static constexpr std::size_t kClasses = 24;  // sides up to 2^12 cells
  std::vector<int> begins_ = std::vector<int>(kClasses * kClasses * 2 * kClasses * 4);
};

class Placer {
 public:
  Placer(const std::vector<PackItem>& items, const PlaceStrategy& strategy, const PackGrid& grid,
         const std::vector<FreeMap>& start, const PlaceOptions& options)
      : items_(items),
        strategy_(strategy),
        grid_(grid),
        options_(options),
        tiles_(start),
        begins_(start.size()),
        raster_(grid) {
    Rasters* const kept = options_.rasters;
    if (kept && kept->texelsPerUnit != options_.texelsPerUnit)
      *kept = {options_.texelsPerUnit, {}, {}};
  }

  Placed run() {
    Placed out;
    out.spots.resize(items_.size());
    std::size_t count = 0;
    for (const std::uint32_t i : strategy_.order) {
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
    const double scale = options_.texelsPerUnit, cell = grid_.cell;
    const double area = item.mass.area * (scale / cell) * (scale / cell);
    const std::size_t poses = item.poses.size();
    const std::size_t step =
        std::max<std::size_t>(poses / static_cast<std::size_t>(strategy_.angles), 1);
    double lowest = 2.0 * tile.height();
    bool isFound = false;
    for (std::size_t p = 0; p < poses; p += step) {
      const Pose& pose = item.poses[p];
      const double width = cellsOf(grid_, pose.width * scale);
      const double height = cellsOf(grid_, pose.height * scale);
      if (width > tile.width() || height > tile.height()) continue;
      const double above = rounded((pose.rotated(item.mass.center).y - pose.minY) * scale / cell);
      const int end = std::min(static_cast<int>(std::ceil(lowest - above)), tile.height());
      int& begin = begins_[t].of(width, height, area, 4 * p / poses);
      if (begin >= end) continue;
      const Cell found = tile.find(footprintOf(i, static_cast<std::uint32_t>(p)), begin, end);
      begin = std::max(begin, found.isFound() ? found.y : end);
      if (!found.isFound()) continue;
      lowest = found.y + above;
      isFound = true;
      spot = {t, static_cast<std::uint32_t>(p), found};
    }
    return isFound;
  }

  const Footprint& footprintOf(std::uint32_t i, std::uint32_t pose) {
    const auto make = [&](Footprint& out) {
      out.set(raster_.touched(items_[i].loops, items_[i].poses[pose], options_.texelsPerUnit));
    };
    if (!options_.rasters) {
      make(footprint_);
      return footprint_;
    }
    const auto [place, isNew] = options_.rasters->touched.try_emplace({i, pose});
    if (isNew) make(place->second);
    return place->second;
  }

  const BitGrid& takenBy(std::uint32_t i, std::uint32_t pose) {
    const auto make = [&]() -> const BitGrid& {
      return raster_.taken(items_[i].loops, items_[i].poses[pose], options_.texelsPerUnit);
    };
    if (!options_.rasters) return make();
    const auto [place, isNew] = options_.rasters->taken.try_emplace({i, pose});
    if (isNew) place->second = make();
    return place->second;
  }

  void take(std::uint32_t i, const Spot& spot) {
    const BitGrid& taken = takenBy(i, spot.pose);
    tiles_[spot.tile].take(taken, spot.cell.x - raster_.shift(), spot.cell.y - raster_.shift());
  }

  const std::vector<PackItem>& items_;
  const PlaceStrategy& strategy_;
  const PackGrid& grid_;
  const PlaceOptions& options_;
  std::vector<FreeMap> tiles_;
  std::vector<SearchBegins> begins_;
  PackRaster raster_;
  Footprint footprint_;
};

}  // namespace

Placed place(const std::vector<PackItem>& items, const PlaceStrategy& strategy,
             const PackGrid& grid, const std::vector<FreeMap>& start, const PlaceOptions& options) {
  return Placer(items, strategy, grid, start, options).run();
}

}  // namespace abflat
