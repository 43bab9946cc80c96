#include "pack/scale_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "pack/scale_bounds.h"
#include "pack/strategies.h"

namespace abflat {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// The search on a single grid.
class Search {
 public:
  /// `usualTries`: total over all searches that share `best`.
  Search(const std::vector<PackItem>& items, const PackGrid& grid, const BitGrid& taken,
         const ScaleOptions& options, double usualTries, ScaleSearch& best)
      : items_(items),
        grid_(grid),
        taken_(1, taken),
        options_(options),
        usualTries_(usualTries),
        spaces_(isParallel(options.pool) ? options.pool->threads() : 1),
        bounds_(scaleBounds(items, grid, taken)),
        out_(best) {}

  /// Whether there is nothing to search, because boxes alone limit the scale.
  bool isAtBound(const std::vector<PlaceStrategy>& strategies) {
    const std::size_t count = std::min<std::size_t>(strategies.size(), 2);
    return bounds_.guess == bounds_.most && attempt(bounds_.most, strategies, 0, count) != kNone;
  }

  /// Finds a scale at which the first strategy fits. False if there is none.
  bool begin(const std::vector<PlaceStrategy>& strategies) {
    // The part that was placed would fill the tile; a little more room is lost between the charts.
    constexpr double kLeastStep = 0.8, kMostStep = 0.985;
    double scale = bounds_.guess;
    for (double most = kMostStep; attempt(scale, strategies, 0, 1) == kNone; most *= kMostStep) {
      if (scale <= bounds_.least || isCancelled_) return false;
      bad_ = scale;
      scale = std::max(scale * most * std::max(std::sqrt(placedShare_), kLeastStep), bounds_.least);
    }
    return true;
  }

  /// Steps up until `count` strategies in a row fail, starting with `strategy` and then always with
  /// the last one that succeeded, which is returned.
  std::size_t climb(const std::vector<PlaceStrategy>& strategies, std::size_t strategy,
                    std::size_t count, double step) {
    bool isBold = true;
    for (std::size_t failures = 0; failures < count && !isOver();) {
      const double next = std::min(out_.texelsPerUnit * step, bounds_.most);
      if (!(next > out_.texelsPerUnit) || (count == 1 && next >= bad_)) break;
      const double bold = boldScale();
      if (isBold && bold > next) {
        isBold = attempt(bold, strategies, strategy, 1) != kNone;
        if (isBold)
          failures = 0;
        else
          bad_ = bold;
        continue;
      }
      const std::size_t fitting = attempt(next, strategies, strategy + failures,
                                          std::min(spaces_.size(), count - failures));
      isBold = fitting != kNone;
      if (isBold && fitting != strategy) bad_ = kInfinity;
      if (isBold) strategy = fitting;
      failures = isBold ? 0 : failures + spaces_.size();
    }
    bad_ = kInfinity;
    return strategy;
  }

  bool isCancelled() const { return isCancelled_; }

 private:
  bool isOver() const {
    return isCancelled_ ||
           (out_.texelsPerUnit > 0 && options_.work > 0 && out_.work >= options_.work);
  }

  /// A scale that should fit as well, judging by the unused height.
  double boldScale() const {
    const double scale = out_.texelsPerUnit, rows = std::max(out_.best.rows, 1);
    const double guess = scale * std::sqrt(grid_.cells() / rows);
    return std::min(guess < bad_ ? guess : (scale + bad_) / 2, bounds_.most);
  }

  /// Behaves as if `count` strategies from `first` on were tried until one fits, which is returned,
  /// but tries several at a time.
  std::size_t attempt(double scale, const std::vector<PlaceStrategy>& strategies, std::size_t first,
                      std::size_t count) {
    std::size_t fitting = kNone;
    for (std::size_t k = 0; k < count && fitting == kNone; k += spaces_.size())
      fitting = attemptAtOnce(scale, strategies, first + k, std::min(spaces_.size(), count - k));
    return fitting;
  }

  std::size_t attemptAtOnce(double scale, const std::vector<PlaceStrategy>& strategies,
                            std::size_t first, std::size_t count) {
    if (isOver() || !tell(0)) return kNone;
    PlaceOptions options;
    options.texelsPerUnit = scale;
    if (count == 1) options.onPlaced = [this](std::size_t placed) { return tell(placed); };
    std::vector<Placed> placed(count);
    const auto indexOf = [&](std::size_t k) { return (first + k) % strategies.size(); };
    parallelFor(options_.pool, count, [&](std::size_t k) {
      if (strategies.size() >= kLeastToKeep) spaces_[k].keepCells(items_);
      placed[k] = place(items_, strategies[indexOf(k)], grid_, taken_, options, spaces_[k]);
    });
    for (std::size_t k = 0; k < count && !isOver(); ++k) {
      ++out_.tries;
      out_.work += placed[k].work;
      const bool fits = placed[k].fit == Fit::All;
      if (!fits) noteMissing(placed[k].missing, strategies[indexOf(k)]);
      if (fits || out_.texelsPerUnit == 0) out_.best = std::move(placed[k]);
      if (!fits) continue;
      out_.texelsPerUnit = scale;
      return indexOf(k);
    }
    return kNone;
  }

  void noteMissing(std::uint32_t missing, const PlaceStrategy& strategy) {
    double before = 0, all = 0;
    for (std::size_t k = 0; k < items_.size() && strategy.order[k] != missing; ++k)
      before += items_[strategy.order[k]].mass.area;
    for (const PackItem& item : items_) all += item.mass.area;
    placedShare_ = all > 0 ? before / all : 0;
  }

  /// Reports how many items the current try has placed.
  bool tell(std::size_t placed) {
    if (!options_.progress || placed % 64 != 0) return true;
    const double share = static_cast<double>(placed) / static_cast<double>(items_.size() + 1);
    isCancelled_ = !options_.progress(1 - std::exp(-2 * (out_.tries + share) / usualTries_));
    return !isCancelled_;
  }

  /// With this many strategies at the same scale, keeping cells is worth the memory.
  static constexpr std::size_t kLeastToKeep = 3;

  const std::vector<PackItem>& items_;
  const PackGrid grid_;
  const std::vector<BitGrid> taken_;
  const ScaleOptions& options_;
  const double usualTries_;
  std::vector<PlaceSpace> spaces_;  ///< one per concurrent try
  const ScaleBounds bounds_;
  ScaleSearch& out_;
  double bad_ = kInfinity;  ///< the last scale that did not fit, apart from small steps up
  double placedShare_ = 0;  ///< share of the area placed by the last try that did not fit
  bool isCancelled_ = false;
};

/// Moves the places to a grid of smaller cells, a whole number of which make up a larger one.
void refine(const std::vector<PackItem>& items, const PackGrid& from, const PackGrid& to,
            ScaleSearch& found) {
  const int parts = from.cell / to.cell;
  found.best.rows *= parts;
  const auto cells = [&](double more) { return static_cast<int>(std::lround(more / to.cell)); };
  for (std::size_t i = 0; i < items.size(); ++i) {
    Spot& spot = found.best.spots[i];
    if (!spot.cell.isFound()) continue;
    const Pose pose = items[i].poses[spot.pose];
    const PlanePoint before = margins(from, pose, found.texelsPerUnit);
    const PlanePoint after = margins(to, pose, found.texelsPerUnit);
    spot.cell = {parts * spot.cell.x + cells(before.x - after.x),
                 parts * spot.cell.y + cells(before.y - after.y)};
  }
}

/// Larger cells already show which strategy is best, and which pose of each item, in a fraction of
/// the time.
PackGrid coarseGrid(PackGrid grid, std::size_t items) {
  const double least = items <= kFewItems ? 24 : 16;  // cells along the side of an item
  const double perSide = std::sqrt(static_cast<double>(items));
  while (items > 1 && grid.cells() / 2.0 >= least * perSide) grid.cell *= 2;
  return grid;
}

/// The same order and poses.
PlaceStrategy again(const PlaceStrategy& strategy, const std::vector<Spot>& spots) {
  PlaceStrategy out = strategy;
  for (const Spot& spot : spots) out.poses.push_back(spot.pose);
  return out;
}

}  // namespace

ScaleSearch searchScale(const std::vector<PackItem>& items, const PackGrid& grid,
                        const BitGrid& taken, const ScaleOptions& options) {
  constexpr double kCoarseStep = 1.007, kFineStep = 1.005, kStepOfMany = 1.01;
  constexpr std::size_t kFineStrategies = 8;
  constexpr double kCoarseShare = 0.6;  // of the work; the rest is for the real cells
  const std::vector<PlaceStrategy> strategies = strategiesFor(items);
  const double usualTries = 6 + 2 * static_cast<double>(strategies.size());
  const double fineStep = items.size() > kManyItems ? kStepOfMany : kFineStep;
  ScaleSearch out;
  Search fine(items, grid, taken, options, usualTries, out);
  if (fine.isAtBound(strategies)) return out;
  std::size_t strategy = 0, count = strategies.size();
  bool isCancelled = fine.isCancelled();
  const PackGrid larger = coarseGrid(grid, items.size());
  if (!isCancelled && larger.cell > grid.cell) {
    BitGrid takenOfLarger = taken;
    for (int cell = grid.cell; cell < larger.cell; cell *= 2) takenOfLarger = halved(takenOfLarger);
    ScaleOptions part = options;
    part.work *= kCoarseShare;
    Search coarse(items, larger, takenOfLarger, part, usualTries, out);
    if (coarse.begin(strategies)) {
      strategy = coarse.climb(strategies, 0, count, std::max(kCoarseStep, fineStep));
      refine(items, larger, grid, out);
      fine.climb({again(strategies[strategy], out.best.spots)}, 0, 1, fineStep);
      count = std::min(count, kFineStrategies);
    }
    isCancelled = coarse.isCancelled() || fine.isCancelled();
  }
  if (!isCancelled && (out.texelsPerUnit > 0 || fine.begin(strategies)))
    fine.climb(strategies, strategy, count, fineStep);
  if (isCancelled || fine.isCancelled()) out.best.fit = Fit::Cancelled;
  return out;
}

}  // namespace abflat
