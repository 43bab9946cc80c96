#include "pack/tidy_search.h"

#include <algorithm>
#include <utility>

namespace abflat {
namespace {

/// By how much more texels per unit are worth a chart that lies askew.
constexpr double kWorthwhile = 1.04;

/// The items, of which those that lie level or stand upright are turned by quarters only; empty if
/// that is so for all anyway.
std::vector<PackItem> held(const std::vector<PackItem>& items) {
  const auto changes = [](const PackItem& item) {
    return (item.isLevel || item.isUpright) && item.poses.perQuarter() > 1 && !item.poses.isHeld();
  };
  if (std::none_of(items.begin(), items.end(), changes)) return {};
  std::vector<PackItem> out = items;
  for (PackItem& item : out)
    if (item.isLevel || item.isUpright) item.poses.hold();
  return out;
}

/// The options for the work from one share to another.
ScaleOptions between(double from, double to, const ScaleOptions& options) {
  ScaleOptions out = options;
  out.listener = options.listener.part(from, to);
  return out;
}

}  // namespace

ScaleSearch searchTidyScale(std::vector<PackItem>& items, const PackGrid& grid,
                            const BitGrid& taken, const ScaleOptions& options) {
  std::vector<PackItem> tidy = held(items);
  if (tidy.empty()) return searchScale(items, grid, taken, options);
  constexpr double kHalf = 0.5;
  ScaleSearch any = searchScale(items, grid, taken, between(0, kHalf, options));
  if (any.best.fit != Fit::All) return any;
  ScaleSearch found = searchScale(tidy, grid, taken, between(kHalf, 1, options));
  const int tries = any.tries + found.tries;
  const bool isWorth = any.texelsPerUnit > kWorthwhile * found.texelsPerUnit;
  if (found.best.fit == Fit::TooMany || (found.best.fit == Fit::All && isWorth))
    found = std::move(any);
  else
    items = std::move(tidy);
  found.tries = tries;
  return found;
}

}  // namespace abflat
