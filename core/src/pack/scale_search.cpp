#include "pack/scale_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pack/strategies.h"

namespace abflat {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Area that the items need at least when they keep `gap` from each other (Brunn and Minkowski: a
/// shape grown by a square of side g has at least (sqrt(area) + g)^2).
double grownArea(const std::vector<PackItem>& items, double scale, double gap) {
  double sum = 0;
  for (const PackItem& item : items) {
    const double side = std::sqrt(item.mass.area) * scale + gap;
    sum += side * side;
  }
  return sum;
}

/// The scale at which they need `available`, by bisection below `most`.
double scaleOfArea(const std::vector<PackItem>& items, double gap, double available, double most) {
  double low = 0, high = most;
  for (int i = 0; i < 60 && high > low * (1 + 1e-6); ++i) {
    const double middle = (low + high) / 2;
    (grownArea(items, middle, gap) > available ? high : low) = middle;
  }
  return high;
}

class Search {
 public:
  Search(const std::vector<PackItem>& items, const PackGrid& grid, const FreeMap& tile,
         ThreadPool* pool, const std::function<bool(double)>& progress)
      : items_(items),
        grid_(grid),
        start_(1, tile),
        pool_(pool),
        progress_(progress),
        strategies_(strategiesFor(items)),
        rasters_(strategies_.size() > 1 ? atOnce() : 0) {}

  ScaleSearch run() {
    bound();
    if (begin(firstGuess()))
      for (const double step : {1.01, 1.003}) climbAnyhow(step);
    if (isCancelled_) out_.best.fit = Fit::Cancelled;
    return std::move(out_);
  }

 private:
  std::size_t atOnce() const { return isParallel(pool_) ? pool_->threads() : 1; }

  /// Finds a scale that fits, with the first strategy. False when there is none.
  bool begin(double guess) {
    if (!attempt(guess, 0)) return descend(guess);
    for (double step = 1.02; climb(step, 0, 1);) step = std::min(step * step, 1.1);
    return true;
  }

  /// One step up from the best.
  bool climb(double step, std::size_t strategy, std::size_t count) {
    const double scale = std::min(out_.texelsPerUnit * step, most_);
    return scale > out_.texelsPerUnit && attempt(scale, strategy, count);
  }

  /// Steps up until no strategy has one any more, beginning with the last that had.
  void climbAnyhow(double step) {
    for (std::size_t failures = 0; failures < strategies_.size() && !isCancelled_;) {
      const std::size_t count = std::min(atOnce(), strategies_.size() - failures);
      if (climb(step, lastGood_, count)) {
        failures = 0;
      } else {
        failures += count;
        lastGood_ = (lastGood_ + count) % strategies_.size();
      }
    }
  }

  /// False when nothing fits.
  bool descend(double from) {
    double scale = from;
    for (double step = 0.96; scale > least_ && !isCancelled_; step *= step) {
      scale = std::max(scale * step, least_);
      if (attempt(scale, 0)) return true;
    }
    return false;
  }

  /// No scale above `most_` is possible, because of the boxes of the items and their area; at
  /// `least_` each item takes one texel.
  void bound() {
    const double side = grid_.resolution - 2 * grid_.border;
    double widest = 0, narrowest = 0;
    for (const PackItem& item : items_) {
      double narrow = kInfinity;
      for (const Pose& pose : item.poses) {
        widest = std::max({widest, pose.width, pose.height});
        narrow = std::min(narrow, std::max(pose.width, pose.height));
      }
      if (!item.poses.empty()) narrowest = std::max(narrowest, narrow);
    }
    if (widest == 0) {
      most_ = least_ = 1;
      return;
    }
    const double room = (side + grid_.padding) * (side + grid_.padding);
    most_ = scaleOfArea(items_, grid_.padding, room, (side - 4 * grid_.slack) / narrowest);
    least_ = std::min(most_, grid_.slack / widest);
  }

  double firstGuess() const {
    const double side = grid_.resolution - 2 * grid_.border + grid_.padding;
    const double cells = static_cast<double>(grid_.cells());
    const double freeShare = start_[0].freeCells() / (cells * cells);
    // Charts fill about that much of what is free; half a cell is lost on each side.
    constexpr double kFill = 0.78;
    const double scale =
        scaleOfArea(items_, grid_.padding + grid_.cell, kFill * freeShare * side * side, most_);
    return std::max({scale, 1e-3 * most_, least_});
  }

  /// As if `count` strategies from `strategy` on were tried until one fits; several at a time.
  bool attempt(double scale, std::size_t strategy, std::size_t count = 1) {
    if (isCancelled_ || !tell(0)) return false;
    PlaceOptions options;
    options.texelsPerUnit = scale;
    if (count == 1) options.onPlaced = [this](std::size_t placed) { return tell(placed); };
    std::vector<Placed> placed(count);
    parallelFor(pool_, count, [&](std::size_t k) {
      const std::size_t s = (strategy + k) % strategies_.size();
      PlaceOptions own = options;
      if (k < rasters_.size()) own.rasters = &rasters_[k];
      placed[k] = place(items_, strategies_[s], grid_, start_, own);
    });
    for (std::size_t k = 0; k < count; ++k) {
      ++out_.tries;
      const bool fits = placed[k].fit == Fit::All;
      if (fits || out_.texelsPerUnit == 0) out_.best = std::move(placed[k]);
      if (!fits) continue;
      out_.texelsPerUnit = scale;
      lastGood_ = (strategy + k) % strategies_.size();
      return true;
    }
    return false;
  }

  /// Of the current try that many items are placed.
  bool tell(std::size_t placed) {
    if (!progress_ || placed % 64 != 0) return true;
    const double share = static_cast<double>(placed) / static_cast<double>(items_.size() + 1);
    const double usualTries = 6 + 3 * static_cast<double>(strategies_.size());
    isCancelled_ = !progress_(1 - std::exp(-2 * (out_.tries + share) / usualTries));
    return !isCancelled_;
  }

  const std::vector<PackItem>& items_;
  const PackGrid& grid_;
  const std::vector<FreeMap> start_;
  ThreadPool* pool_;
  const std::function<bool(double)>& progress_;
  const std::vector<PlaceStrategy> strategies_;
  std::vector<Rasters> rasters_;  ///< of each try at once
  std::size_t lastGood_ = 0;
  ScaleSearch out_;
  double most_ = 0, least_ = 0;
  bool isCancelled_ = false;
};

}  // namespace

ScaleSearch searchScale(const std::vector<PackItem>& items, const PackGrid& grid,
                        const FreeMap& tile, ThreadPool* pool,
                        const std::function<bool(double)>& progress) {
  return Search(items, grid, tile, pool, progress).run();
}

}  // namespace abflat
