#include "pack/placer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace abflat {
namespace {

/// Twice the base-2 logarithm, rounded down: sizes within a factor of 1.4 are similar.
std::size_t sizeClass(double x) {
  int exponent = 0;
  const bool isUpper = std::frexp(x + 1, &exponent) >= 0.70710678118654752;
  return 2 * static_cast<std::size_t>(exponent - 1) + (isUpper ? 1 : 0);
}

/// Keeps rounding errors from choosing between equal poses.
double rounded(double cells) { return std::round(cells * 256) / 256; }

class Placer {
 public:
  Placer(const std::vector<PackItem>& items, const PlaceStrategy& strategy, const PackGrid& grid,
         const std::vector<BitGrid>& taken, const PlaceOptions& options, PlaceSpace& space)
      : items_(items),
        strategy_(strategy),
        grid_(grid),
        options_(options),
        space_(space),
        tiles_(space.tiles),
        begins_(space.begins),
        raster_(grid),
        longest_(longestRun(longestSide(items))),
        isFull_(taken.size(), 0) {
    tiles_.resize(taken.size());
    begins_.assign(taken.size(), {});
    for (std::size_t t = 0; t < taken.size(); ++t) {
      tiles_[t].reset(grid_.columns(), grid_.rows(), longest_);
      tiles_[t].take(taken[t], 0, 0);
    }
    if (!options.start) return;
    tiles_[0] = options.start->tile;
    begins_[0] = options.start->begins;
  }

  Placed run() {
    Placed out;
    out.spots.resize(items_.size());
    std::size_t count = 0;
    double missing = 0;
    lookAhead();
    for (position_ = 0; position_ < strategy_.order.size(); ++position_) {
      const std::uint32_t i = strategy_.order[position_];
      limitTiles();
      if (!tell(count)) {
        out.fit = Fit::Cancelled;
        return out;
      }
      if (!items_[i].loops.points.empty() && !placeItem(i, out.spots[i])) {
        if (out.fit == Fit::All) out.missing = i;
        out.fit = Fit::TooMany;
        out.work = work_;
        missing += items_[i].mass.area;
        if (missing > options_.mostMissing) return out;
        continue;
      }
      out.rows = std::max(out.rows, topOf(i, out.spots[i]));
      if (++count < items_.size()) take(i, out.spots[i]);
    }
    out.work = work_;
    out.tiles = static_cast<std::uint32_t>(tiles_.size());
    return out;
  }

 private:
  bool tell(std::size_t placed) const {
    constexpr std::size_t kEvery = 64;
    if (placed % kEvery != 0) return !options_.listener.isStopped();
    return options_.listener.tell(static_cast<double>(placed) /
                                  static_cast<double>(items_.size() + 1));
  }

  /// No run of a footprint is longer.
  int longestRun(double side) const {
    const double more = grid_.snaps ? kMostSnapped : 0;
    const double cells = cellsOf(grid_, side * options_.texelsPerUnit + more);
    return static_cast<int>(std::min<double>(cells, grid_.columns()));
  }

  /// The longest run of each footprint is at least this long: as if its cells were spread evenly
  /// over rows.
  int leastRun(const PackItem& item) const {
    if (item.loops.points.empty()) return grid_.columns();
    constexpr double kAlmostAll = 0.999;
    const double left = grid_.snaps ? kLeastSnapped * kLeastSnapped : 1;
    const double scale = options_.texelsPerUnit / grid_.cell;
    const double rows = longestRun(longestSide(item));
    return static_cast<int>(std::min<double>(
        std::ceil(kAlmostAll * left * item.mass.area * scale * scale / rows), grid_.columns()));
  }

  bool isPosed() const { return !strategy_.poses.empty(); }

  bool placeItem(std::uint32_t i, Spot& spot) {
    for (std::uint32_t t = 0; t < options_.mostTiles; ++t) {
      const bool isNew = t == tiles_.size();
      if (isNew) openTile();
      if (isFull_[t]) continue;
      if (findIn(t, i, spot)) return true;
      if (isNew) return false;
    }
    return false;
  }

  /// Computes what the items from each position of the order on need.
  void lookAhead() {
    remaining_.resize(strategy_.order.size());
    Runs now{1, grid_.columns()};
    for (std::size_t k = remaining_.size(); k-- > 0;) {
      const PackItem& item = items_[strategy_.order[k]];
      now.longest = std::max(now.longest, longestRun(longestSide(item)));
      now.least = std::min(now.least, leastRun(item));
      remaining_[k] = now;
    }
  }

  /// Tiles are kept up for the longest run of any remaining item.
  void limitTiles() {
    const int longest = remaining_[position_].longest;
    const bool isSame = position_ > 0 && longest == remaining_[position_ - 1].longest;
    if (options_.isTileKept || isSame) return;
    for (std::size_t t = 0; t < tiles_.size(); ++t)
      if (!isFull_[t]) tiles_[t].limit(longest);
  }

  /// Drops the memory of tiles that have no room for any remaining item; others keep what these
  /// items need.
  void openTile() {
    const auto [longest, least] = remaining_[position_];
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
      if (isFull_[t]) continue;
      isFull_[t] = tiles_[t].mostFree() < least;
      if (isFull_[t]) {
        tiles_[t] = {};
        begins_[t] = {};
      } else {
        tiles_[t].limit(longest);
        tiles_[t].shrink();
      }
    }
    tiles_.emplace_back();
    tiles_.back().reset(grid_.columns(), grid_.rows(), longest);
    begins_.emplace_back();
    isFull_.push_back(0);
  }

  bool findIn(std::uint32_t t, std::uint32_t i, Spot& spot) {
    FreeMap& tile = tiles_[t];
    const PackItem& item = items_[i];
    const double cell = grid_.cell, perUnit = options_.texelsPerUnit / cell;
    const double area = item.mass.area * perUnit * perUnit;
    const double dearness = strategy_.tidiness * std::sqrt(area);
    const std::size_t count = isPosed() ? 1 : strategy_.turns.size();
    double lowest = 2.0 * tile.height();
    bool isFound = false;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t p = isPosed() ? strategy_.poses[i] : item.poses.kept(strategy_.turns[k]);
      const Pose pose = item.poses[p];
      const PlanePoint scale = texelScale(grid_, pose, options_.texelsPerUnit);
      const double width = cellsOf(grid_, pose.width * scale.x);
      const double height = cellsOf(grid_, pose.height * scale.y);
      if (width > tile.width() || height > tile.height()) continue;
      const double center = (pose.rotated(item.mass.center).y - pose.minY) * scale.y / cell;
      const double above = rounded(center + dearness * untidiness(item, p));
      const int end = std::min(static_cast<int>(std::ceil(lowest - above)), tile.height());
      int& begin = begins_[t].of(width, height, area, 4 * p / item.poses.size());
      if (begin >= end) continue;
      work_ += height;
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
    const Poses& poses = items_[i].poses;
    if (isPosed()) {
      footprints_[0].set(raster_.touched(items_[i].loops, poses[pose], options_.texelsPerUnit));
      return footprints_[0];
    }
    const auto quarter = static_cast<std::uint32_t>(poses[pose].quarter);
    const std::uint32_t first = pose - quarter * static_cast<std::uint32_t>(poses.size() / 4);
    const auto make = [&](PlaceSpace::Footprints& out) {
      const BitGrid& touched =
          raster_.touched(items_[i].loops, poses[first], options_.texelsPerUnit);
      out[0].set(touched);
      if (poses.size() < 4) return;
      out[2].setMirrored(out[0], true, true);
      // The two angles differ by half a turn. Cells that are kept may serve more angles.
      if (strategy_.turns.size() == 2 && space_.touched.empty()) return;
      transpose(touched, transposed_);
      upright_.set(transposed_);
      out[1].setMirrored(upright_, true, false);
      out[3].setMirrored(upright_, false, true);
    };
    if (space_.touched.empty() && made_ == std::make_pair(i, first)) return footprints_[quarter];
    made_ = {i, first};
    return keptOr(space_.touched, i, first, footprints_, make)[quarter];
  }

  const BitGrid& takenBy(std::uint32_t i, std::uint32_t pose) {
    return keptOr(space_.taken, i, pose, taken_, [&](BitGrid& out) {
      out = raster_.taken(items_[i].loops, items_[i].poses[pose], options_.texelsPerUnit);
    });
  }

  /// The kept cells, or newly made ones.
  template <typename Cells, typename Make>
  const Cells& keptOr(std::vector<PlaceSpace::AtScale<Cells>>& kept, std::uint32_t i,
                      std::uint32_t pose, Cells& otherwise, const Make& make) {
    if (kept.empty()) {
      make(otherwise);
      return otherwise;
    }
    PlaceSpace::AtScale<Cells>& own = kept[i * items_[i].poses.size() + pose];
    if (own.texelsPerUnit != options_.texelsPerUnit) make(own.cells);
    own.texelsPerUnit = options_.texelsPerUnit;
    return own.cells;
  }

  /// The first row above the item.
  int topOf(std::uint32_t i, const Spot& spot) const {
    if (!spot.cell.isFound()) return 0;
    const Pose pose = items_[i].poses[spot.pose];
    const double height = pose.height * texelScale(grid_, pose, options_.texelsPerUnit).y;
    return spot.cell.y + static_cast<int>(cellsOf(grid_, height));
  }

  void take(std::uint32_t i, const Spot& spot) {
    if (!spot.cell.isFound()) return;
    const BitGrid& taken = takenBy(i, spot.pose);
    work_ += taken.height;
    tiles_[spot.tile].take(taken, spot.cell.x - raster_.shift(), spot.cell.y - raster_.shift());
  }

  const std::vector<PackItem>& items_;
  const PlaceStrategy& strategy_;
  const PackGrid& grid_;
  const PlaceOptions& options_;
  PlaceSpace& space_;
  std::vector<FreeMap>& tiles_;
  std::vector<SearchBegins>& begins_;
  PackRaster raster_;
  PlaceSpace::Footprints footprints_;
  std::pair<std::uint32_t, std::uint32_t> made_ = {~0u, 0};
  BitGrid transposed_;
  Footprint upright_;
  BitGrid taken_;
  const int longest_;
  struct Runs {
    int longest, least;  ///< of the longest runs of items
  };
  std::vector<Runs> remaining_;       ///< by position
  std::vector<std::uint8_t> isFull_;  ///< per tile
  std::size_t position_ = 0;          ///< position in the order
  double work_ = 0;
};

}  // namespace

double longestSide(const PackItem& item) {
  double longest = 0;
  for (std::size_t p = 0; p < item.poses.size(); ++p)
    longest = std::max({longest, item.poses[p].width, item.poses[p].height});
  return longest;
}

double longestSide(const std::vector<PackItem>& items) {
  double longest = 0;
  for (const PackItem& item : items) longest = std::max(longest, longestSide(item));
  return longest;
}

double untidiness(const PackItem& item, std::size_t pose) {
  constexpr double kUpsideDown = 0.5;
  const std::size_t quarter = item.poses.perQuarter();
  if (pose % quarter != 0) return item.isLevel || item.isUpright ? 1 : 0;
  if (pose == 0 || !item.isUpright) return 0;
  return pose == 2 * quarter ? kUpsideDown : 1;
}

double scaleForAll(const std::vector<PackItem>& items, double width, double height) {
  double scale = std::numeric_limits<double>::infinity();
  for (const PackItem& item : items) {
    double own = 0;
    for (std::size_t p = 0; p < item.poses.size(); ++p)
      own = std::max(own, std::min(width / item.poses[p].width, height / item.poses[p].height));
    if (!item.poses.empty()) scale = std::min(scale, own);
  }
  return scale;
}

int& SearchBegins::of(double width, double height, double area, std::size_t quarter) {
  constexpr std::size_t kClasses = 64;
  const std::size_t key =
      (sizeClass(width) * kClasses + sizeClass(height)) * kClasses + sizeClass(area);
  return begins_[static_cast<std::uint32_t>(4 * key + quarter)];
}

void PlaceSpace::keepCells(const std::vector<PackItem>& items) {
  const std::size_t poses = items.empty() ? 0 : items[0].poses.size();
  touched.resize(items.size() * poses);
  taken.resize(items.size() * poses);
}

Placed place(const std::vector<PackItem>& items, const PlaceStrategy& strategy,
             const PackGrid& grid, const std::vector<BitGrid>& taken, const PlaceOptions& options,
             PlaceSpace& space) {
  return Placer(items, strategy, grid, taken, options, space).run();
}

}  // namespace abflat
