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
/// Charts that lie level and upright are worth a texel density that is this many times smaller. Of
/// few charts each is seen, so these are worth more.
constexpr double kWorthOfTidiness = 1.03, kWorthOfFewTidy = 1.05;
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
        out_(best),
        work_(options.work) {}

  /// Whether there is nothing to search, because boxes alone limit the scale.
  bool isAtBound(const std::vector<PlaceStrategy>& strategies) {
    const std::size_t count = std::min<std::size_t>(strategies.size(), 2);
    return bounds_.guess == bounds_.most && attempt(bounds_.most, strategies, 0, count) != kNone;
  }

  /// Finds a scale at which the first strategy fits. False if there is none.
  bool begin(const std::vector<PlaceStrategy>& strategies) {
    // The part that was placed would fill the tile; a little more room is lost between the charts.
    constexpr double kLeastStep = 0.8, kMostStep = 0.985;
    double scale = options_.former > 0 ? std::clamp(options_.former, bounds_.least, bounds_.most)
                                       : bounds_.guess;
    // What is higher has not fitted before.
    if (options_.former > 0) bad_ = scale * (1 + 1e-9);
    for (double most = kMostStep; attempt(scale, strategies, 0, 1) == kNone; most *= kMostStep) {
      if (scale <= bounds_.least || isStopped()) return false;
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

  /// Gives up texels for tidier charts: steps up again from a scale that is smaller by what they
  /// are worth. kNone, with nothing changed, if no strategy fits there.
  std::size_t settle(const std::vector<PlaceStrategy>& strategies, double step) {
    const std::size_t count = strategies.size();
    const double worth = items_.size() <= kFewItems ? kWorthOfFewTidy : kWorthOfTidiness;
    const std::size_t fitting = attempt(out_.texelsPerUnit / worth, strategies, 0, count);
    return fitting == kNone ? kNone : climb(strategies, fitting, count, step);
  }

  void limitWork(double work) { work_ = work; }

 private:
  bool isStopped() const { return options_.listener.isStopped(); }
  bool isOver() const {
    return isStopped() || (out_.texelsPerUnit > 0 && work_ > 0 && out_.work >= work_);
  }

  /// A scale that should fit as well, judging by the unused height.
  double boldScale() const {
    const double scale = out_.texelsPerUnit, rows = std::max(out_.best.rows, 1);
    const double guess = scale * std::sqrt(grid_.rows() / rows);
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
    if (isOver()) return kNone;
    const Listener listener =
        options_.listener.part(shareAfter(out_.tries), shareAfter(out_.tries + 1));
    if (!listener.tell(0)) return kNone;
    PlaceOptions options;
    options.texelsPerUnit = scale;
    options.listener = listener;
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

  /// Of all the work, roughly.
  double shareAfter(int tries) const { return 1 - std::exp(-2 * tries / usualTries_); }

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
  double work_;
  double bad_ = kInfinity;  ///< the last scale that did not fit, apart from small steps up
  double placedShare_ = 0;  ///< share of the area placed by the last try that did not fit
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
  const auto meanSide = [&] { return AtlasSize(grid.columns(), grid.rows()).meanSide(); };
  const auto shorter = [&] { return std::min(grid.columns(), grid.rows()); };
  while (items > 1 && meanSide() / 2 >= least * perSide && shorter() >= 2 * least) grid.cell *= 2;
  return grid;
}

/// The same order and poses.
PlaceStrategy again(const PlaceStrategy& strategy, const std::vector<Spot>& spots) {
  PlaceStrategy out = strategy;
  for (const Spot& spot : spots) out.poses.push_back(spot.pose);
  return out;
}

/// Large cells first, then the real ones.
class WholeSearch {
 public:
  WholeSearch(const std::vector<PackItem>& items, const PackGrid& grid, const BitGrid& taken,
              const ScaleOptions& options)
      : items_(items),
        grid_(grid),
        taken_(taken),
        options_(options),
        strategies_(strategiesFor(items, items.size() > kSeveralItems ? kLessTidy : 0)),
        usualTries_(6 + 2 * static_cast<double>(strategies_.size())),
        fineStep_(items.size() > kManyItems ? kStepOfMany : kFineStep),
        fine_(items, grid, taken, options, usualTries_, out_) {}

  ScaleSearch run() {
    if (fine_.isAtBound(strategies_)) {
      for (const double tidiness : {kTidiest, kLessTidy})
        if (fine_.isAtBound({strategiesFor(items_, tidiness).front()})) break;
      return std::move(out_);
    }
    searchLargeCells();
    searchRealCells();
    if (options_.listener.isStopped()) out_.best.fit = Fit::Cancelled;
    return std::move(out_);
  }

 private:
  void searchLargeCells() {
    constexpr double kCoarseStep = 1.007;
    // Of the work; the rest is for the real cells.
    constexpr double kUntidyShare = 0.5, kCoarseShare = 0.6;
    const PackGrid larger = coarseGrid(grid_, items_.size());
    if (options_.listener.isStopped() || larger.cell == grid_.cell) return;
    BitGrid takenOfLarger = taken_;
    for (int cell = grid_.cell; cell < larger.cell; cell *= 2)
      takenOfLarger = halved(takenOfLarger);
    Search coarse(items_, larger, takenOfLarger, options_, usualTries_, out_);
    coarse.limitWork(kUntidyShare * options_.work);
    if (coarse.begin(strategies_)) {
      const double step = std::max(kCoarseStep, fineStep_);
      strategy_ = coarse.climb(strategies_, 0, strategies_.size(), step);
      coarse.limitWork(kCoarseShare * options_.work);
      settle(coarse, step);
      refine(items_, larger, grid_, out_);
      fine_.climb({again(strategies_[strategy_], out_.best.spots)}, 0, 1, fineStep_);
    }
  }

  void searchRealCells() {
    constexpr std::size_t kStrategies = 8;  // once the poses are chosen
    constexpr double kUntidyShare = 0.8;    // of the work
    if (options_.listener.isStopped()) return;
    if (out_.texelsPerUnit > 0) {
      fine_.climb(strategies_, strategy_, std::min(strategies_.size(), kStrategies), fineStep_);
      return;
    }
    fine_.limitWork(kUntidyShare * options_.work);
    if (!fine_.begin(strategies_)) return;
    strategy_ = fine_.climb(strategies_, 0, strategies_.size(), fineStep_);
    fine_.limitWork(options_.work);
    settle(fine_, fineStep_);
  }

  /// Whether all items already lie as they should.
  bool isTidy() const {
    for (std::size_t i = 0; i < items_.size(); ++i)
      if (!items_[i].poses.empty() && untidiness(items_[i], out_.best.spots[i].pose) > 0)
        return false;
    return true;
  }

  /// Goes on with the tidiest strategies that are worth it. Where there
  /// are many items, a try or two is all there is work for.
  void settle(Search& search, double step) {
    if (items_.size() > kSeveralItems || isTidy()) return;
    for (const double tidiness : {kTidiest, kLessTidy}) {
      std::vector<PlaceStrategy> tidier = strategiesFor(items_, tidiness);
      const std::size_t fitting = search.settle(tidier, step);
      if (fitting == kNone) continue;
      strategies_ = std::move(tidier);
      strategy_ = fitting;
      return;
    }
  }

  static constexpr double kFineStep = 1.005, kStepOfMany = 1.01;

  const std::vector<PackItem>& items_;
  const PackGrid grid_;
  const BitGrid& taken_;
  const ScaleOptions& options_;
  std::vector<PlaceStrategy> strategies_;
  std::size_t strategy_ = 0;  ///< the best one
  const double usualTries_, fineStep_;
  ScaleSearch out_;
  Search fine_;
};

}  // namespace

ScaleSearch searchScale(const std::vector<PackItem>& items, const PackGrid& grid,
                        const BitGrid& taken, const ScaleOptions& options) {
  return WholeSearch(items, grid, taken, options).run();
}

}  // namespace abflat
