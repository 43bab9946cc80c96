#include "pack/scale_bounds.h"

#include <algorithm>
#include <cmath>

namespace abflat {
namespace {

/// The least area that items need if they keep `gap` from each other (Brunn and Minkowski: a shape
/// grown by a square of side g has at least the area (sqrt(area) + g)^2).
double grownArea(const std::vector<PackItem>& items, double scale, double gap) {
  double sum = 0;
  for (const PackItem& item : items) {
    const double side = std::sqrt(item.mass.area) * scale + gap;
    sum += side * side;
  }
  return sum;
}

/// The scale at which they need the area `available`, by bisection below `most`.
double scaleOfArea(const std::vector<PackItem>& items, double gap, double available, double most) {
  double low = 0, high = most;
  for (int i = 0; i < 60 && high > low * (1 + 1e-6); ++i) {
    const double middle = (low + high) / 2;
    (grownArea(items, middle, gap) > available ? high : low) = middle;
  }
  return high;
}

}  // namespace

ScaleBounds scaleBounds(const std::vector<PackItem>& items, const PackGrid& grid,
                        const BitGrid& taken) {
  // For charts of the tiniest possible size the scale would be infinite.
  constexpr double kFiniteScale = 1e300;
  const double longest = longestSide(items);
  if (longest == 0) return {};
  const double width = grid.resolution.width - 2 * grid.margin;
  const double height = grid.resolution.height - 2 * grid.margin;
  const double padded = (width + grid.padding) * (height + grid.padding);
  ScaleBounds out;
  const double most = scaleForAll(items, width - 4 * grid.slack, height - 4 * grid.slack);
  out.most = scaleOfArea(items, grid.padding, padded, std::min(most, kFiniteScale));
  out.least = std::min(out.most, grid.slack / longest);
  // Charts fill about this share of the free area; half a cell is lost on each side.
  constexpr double kFill = 0.72;
  const double freeShare =
      1 - countCells(taken) / (static_cast<double>(grid.columns()) * grid.rows());
  const double scale =
      scaleOfArea(items, grid.padding + grid.cell, kFill * freeShare * padded, out.most);
  out.guess = std::max({scale, 1e-3 * out.most, out.least});
  return out;
}

}  // namespace abflat
