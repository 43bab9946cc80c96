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

/// The search on one grid.
class Search {
 public:
  Search(const std::vector<PackItem>& items, const PackGrid& grid, const FreeMap& tile,
         const std::vector<PlaceStrategy>& strategies, const ScaleOptions& options,
         ScaleSearch& best)
      : items_(items),
        grid_(grid),
        start_(1, tile),
        strategies_(strategies),
        options_(options),
        spaces_(isParallel(options.pool) ? options.pool->threads() : 1),
        bounds_(scaleBounds(items, grid, tile)),
        out_(best) {
    if (strategies_.size() > 1)
      for (PlaceSpace& space : spaces_) space.keepCells(items);
  }

  /// Whether there is nothing to search because boxes are what bounds the scale.
  bool isAtBound() {
    return bounds_.guess == bounds_.most && attempt(bounds_.most, 0, mostFirst());
  }

  /// Finds a scale that fits. False when there is none.
  bool begin() {
    // The part that was placed would fill the tile; a little more room is lost between the charts.
    constexpr double kLeastStep = 0.8, kMostStep = 0.985;
    double scale = bounds_.guess;
    for (double most = kMostStep; !attempt(scale, 0, mostFirst()); most *= kMostStep) {
      if (scale <= bounds_.least || isCancelled_) return false;
      bad_ = scale;
      scale = std::max(scale * most * std::max(std::sqrt(placedShare_), kLeastStep), bounds_.least);
    }
    return true;
  }

  /// Steps up until `count` strategies have none any more, beginning with the last that had.
  void climb(double step, std::size_t count) {
    bool isBold = true;
    for (std::size_t failures = 0; failures < count && !isOver();) {
      const double next = std::min(out_.texelsPerUnit * step, bounds_.most);
      if (!(next > out_.texelsPerUnit)) return;
      if (strategies_.size() == 1 && next >= bad_) return;
      const double bold = boldScale();
      if (isBold && bold > next) {
        isBold = attempt(bold, out_.strategy, 1);
        if (isBold)
          failures = 0;
        else
          bad_ = bold;
        continue;
      }
      const std::size_t first = out_.strategy + failures;
      isBold = attempt(next, first, std::min(spaces_.size(), count - failures));
      failures = isBold ? 0 : failures + spaces_.size();
    }
  }

  bool isCancelled() const { return isCancelled_; }

 private:
  std::size_t mostFirst() const { return std::min<std::size_t>(strategies_.size(), 2); }

  bool isOver() const {
    return isCancelled_ ||
           (out_.texelsPerUnit > 0 && options_.work > 0 && out_.work >= options_.work);
  }

  /// What should fit as well, by the height that was not used.
  double boldScale() const {
    const double scale = out_.texelsPerUnit, rows = std::max(out_.best.rows, 1);
    const double guess = scale * std::sqrt(grid_.cells() / rows);
    return std::min(guess < bad_ ? guess : (scale + bad_) / 2, bounds_.most);
  }

  /// As if `count` strategies from `strategy` on were tried until one fits; several at a time.
  bool attempt(double scale, std::size_t strategy, std::size_t count) {
    placedShare_ = 0;
    for (std::size_t k = 0; k < count; k += spaces_.size())
      if (attemptAtOnce(scale, strategy + k, std::min(spaces_.size(), count - k))) return true;
    return false;
  }

  bool attemptAtOnce(double scale, std::size_t strategy, std::size_t count) {
    if (isOver() || !tell(0)) return false;
    PlaceOptions options;
    options.texelsPerUnit = scale;
    if (count == 1) options.onPlaced = [this](std::size_t placed) { return tell(placed); };
    std::vector<Placed> placed(count);
    const auto strategyOf = [&](std::size_t k) { return (strategy + k) % strategies_.size(); };
    parallelFor(options_.pool, count, [&](std::size_t k) {
      placed[k] = place(items_, strategies_[strategyOf(k)], grid_, start_, options, spaces_[k]);
    });
    for (std::size_t k = 0; k < count && !isOver(); ++k) {
      ++out_.tries;
      out_.work += placed[k].work;
      const bool fits = placed[k].fit == Fit::All;
      if (!fits) noteMissing(placed[k].missing, strategies_[strategyOf(k)]);
      if (fits || out_.texelsPerUnit == 0) out_.best = std::move(placed[k]);
      if (!fits) continue;
      out_.texelsPerUnit = scale;
      out_.strategy = strategyOf(k);
      return true;
    }
    return false;
  }

  void noteMissing(std::uint32_t missing, const PlaceStrategy& strategy) {
    double before = 0, all = 0;
    for (std::size_t k = 0; k < items_.size() && strategy.order[k] != missing; ++k)
      before += items_[strategy.order[k]].mass.area;
    for (const PackItem& item : items_) all += item.mass.area;
    if (all > 0) placedShare_ = std::max(placedShare_, before / all);
  }

  /// Of the current try that many items are placed.
  bool tell(std::size_t placed) {
    if (!options_.progress || placed % 64 != 0) return true;
    const double share = static_cast<double>(placed) / static_cast<double>(items_.size() + 1);
    const double usualTries = 6 + 2 * static_cast<double>(strategies_.size());
    isCancelled_ = !options_.progress(1 - std::exp(-2 * (out_.tries + share) / usualTries));
    return !isCancelled_;
  }

  const std::vector<PackItem>& items_;
  const PackGrid grid_;
  const std::vector<FreeMap> start_;
  const std::vector<PlaceStrategy>& strategies_;
  const ScaleOptions& options_;
  std::vector<PlaceSpace> spaces_;  ///< of each try at once
  const ScaleBounds bounds_;
  ScaleSearch& out_;
  double bad_ = kInfinity;  ///< the last scale that did not fit, but for small steps up
  double placedShare_ = 0;  ///< of the area, at the last scale that did not fit, by the best try
  bool isCancelled_ = false;
};

/// The same places on a grid of cells half as large.
void refine(const std::vector<PackItem>& items, const PackGrid& from, const PackGrid& to,
            ScaleSearch& found) {
  found.best.rows *= 2;
  const auto cells = [&](double more) { return static_cast<int>(std::lround(more / to.cell)); };
  for (std::size_t i = 0; i < items.size(); ++i) {
    Spot& spot = found.best.spots[i];
    if (!spot.cell.isFound()) continue;
    const Pose& pose = items[i].poses[spot.pose];
    const PlanePoint before = margins(from, pose, found.texelsPerUnit);
    const PlanePoint after = margins(to, pose, found.texelsPerUnit);
    spot.cell = {2 * spot.cell.x + cells(before.x - after.x),
                 2 * spot.cell.y + cells(before.y - after.y)};
  }
}

/// Which of many strategies is the best shows on larger cells as well, in less than half the time.
bool hasCoarseGrid(const PackGrid& grid, std::size_t items) {
  constexpr double kLeastCellsOfItem = 16;
  const double side = grid.cells() / 2.0 / std::sqrt(static_cast<double>(items));
  return items > 1 && items <= kFewItems && side >= kLeastCellsOfItem;
}

}  // namespace

ScaleSearch searchScale(const std::vector<PackItem>& items, const PackGrid& grid,
                        const FreeMap& tile, const ScaleOptions& options) {
  constexpr double kCoarseStep = 1.007, kFineStep = 1.005, kOnlyStep = 1.01;
  constexpr std::size_t kFineStrategies = 4;
  const std::vector<PlaceStrategy> strategies = strategiesFor(items);
  ScaleSearch out;
  Search fine(items, grid, tile, strategies, options, out);
  if (fine.isAtBound()) return out;
  std::size_t count = strategies.size();
  bool isCancelled = fine.isCancelled();
  if (!isCancelled && hasCoarseGrid(grid, items.size())) {
    PackGrid larger = grid;
    larger.cell *= 2;
    Search coarse(items, larger, tile.halved(), strategies, options, out);
    if (coarse.begin()) {
      coarse.climb(kCoarseStep, count);
      refine(items, larger, grid, out);
      count = std::min(count, kFineStrategies);
    }
    isCancelled = coarse.isCancelled();
  }
  if (!isCancelled && (out.texelsPerUnit > 0 || fine.begin()))
    fine.climb(strategies.size() > 1 ? kFineStep : kOnlyStep, count);
  if (isCancelled || fine.isCancelled()) out.best.fit = Fit::Cancelled;
  return out;
}

}  // namespace abflat
