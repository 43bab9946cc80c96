#include "pack/scale_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abflat {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Area that the items need at least when they keep `gap` from each other (Brunn and Minkowski: a
/// shape grown by a square of side g has at least (sqrt(area) + g)^2).
double grownArea(const std::vector<PackItem>& items, double scale, double gap) {
  double sum = 0;
  for (const PackItem& item : items) {
    const double side = std::sqrt(item.area) * scale + gap;
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
  Search(const std::vector<PackItem>& items, const std::vector<std::uint32_t>& order,
         const PackGrid& grid, ThreadPool* pool, const std::function<bool(double)>& progress)
      : items_(items), order_(order), grid_(grid), pool_(pool), progress_(progress) {}

  ScaleSearch run() {
    const double most = largestScale(items_, grid_);
    double scale = std::min(firstGuess(most), most);
    double low = 0, high = most;
    if (attempt(scale)) {
      low = scale;
      for (double step = 1.04; !cancelled_ && scale * 1.002 < most; step = 1 + 1.5 * (step - 1)) {
        scale = std::min(scale * step, most);
        if (!attempt(scale)) {
          high = scale;
          break;
        }
        low = scale;
      }
    } else {
      high = scale;
      for (double step = 0.96; !cancelled_; step *= step) {
        scale *= step;
        if (attempt(scale)) {
          low = scale;
          break;
        }
        high = scale;
      }
    }
    while (!cancelled_ && high > low * kPrecision) {
      const double middle = std::sqrt(low * high);
      (attempt(middle) ? low : high) = middle;
    }
    if (cancelled_) out_.best.fit = Fit::Cancelled;
    return std::move(out_);
  }

 private:
  static constexpr double kPrecision = 1.004;
  static constexpr double kUsualTries = 9;

  double firstGuess(double most) const {
    const double side = grid_.resolution - 2 * grid_.border + grid_.padding;
    // Charts fill about that much of the tile; the outer half of a texel is lost on each side.
    constexpr double kFill = 0.78;
    return scaleOfArea(items_, grid_.padding + grid_.cell, kFill * side * side, most);
  }

  bool attempt(double scale) {
    PlaceOptions options;
    options.texelsPerUnit = scale;
    options.pool = pool_;
    if (progress_)
      options.onPlaced = [this](std::size_t placed) {
        if (placed % 64) return true;
        const double share = static_cast<double>(placed) / static_cast<double>(items_.size());
        return progress_(1 - std::exp(-2 * (out_.tries - 1 + share) / kUsualTries));
      };
    ++out_.tries;
    Placed placed = place(items_, order_, grid_, options);
    if (placed.fit == Fit::Cancelled) cancelled_ = true;
    if (placed.fit != Fit::All) return false;
    if (!(scale >= out_.texelsPerUnit)) return true;
    out_.texelsPerUnit = scale;
    out_.best = std::move(placed);
    return true;
  }

  const std::vector<PackItem>& items_;
  const std::vector<std::uint32_t>& order_;
  const PackGrid& grid_;
  ThreadPool* pool_;
  const std::function<bool(double)>& progress_;
  ScaleSearch out_;
  bool cancelled_ = false;
};

}  // namespace

double largestScale(const std::vector<PackItem>& items, const PackGrid& grid) {
  const double inside = grid.resolution - 2 * grid.border;
  double most = kInfinity;
  for (const PackItem& item : items) {
    double side = kInfinity;
    for (const Pose& pose : item.poses) side = std::min(side, std::max(pose.width, pose.height));
    if (side > 0) most = std::min(most, (inside - 4 * grid.slack) / side);
  }
  if (most == kInfinity) return 1;
  return std::min(most, scaleOfArea(items, grid.padding, std::pow(inside + grid.padding, 2), most));
}

ScaleSearch searchScale(const std::vector<PackItem>& items, const std::vector<std::uint32_t>& order,
                        const PackGrid& grid, ThreadPool* pool,
                        const std::function<bool(double)>& progress) {
  return Search(items, order, grid, pool, progress).run();
}

}  // namespace abflat
