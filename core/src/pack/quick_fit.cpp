#include "pack/quick_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "pack/level_pose.h"
#include "pack/strategies.h"

namespace abflat {
namespace {

constexpr double kAnyArea = std::numeric_limits<double>::infinity();

}  // namespace

QuickFit::QuickFit(const PackOptions& options, int cells)
    : poses_(options.rotate == Rotate::None      ? 1
             : options.rotate == Rotate::Quarter ? 4
                                                 : 8),
      rotate_(options.rotate) {
  grid_ = makePackGrid(options, 1);
  const int side = static_cast<int>(options.resolution.meanSide());
  const int shorter = options.resolution.shorter();
  grid_.cell =
      std::max(std::min({side / cells, shorter / kLeastRows, shorter - 2 * grid_.margin}), 1);
}

PackItem QuickFit::itemOf(const std::vector<PlanePoint>& outline) const {
  PackItem out;
  if (outline.empty()) return out;
  out.loops.points = outline;
  out.loops.ends = {static_cast<std::uint32_t>(outline.size())};
  out.loops.isGroup = {1};
  const std::vector<PlanePoint> hull = convexHull(outline);
  LevelPose level;
  if (rotate_ != Rotate::Free) level = levelPose(out.loops, hull, {});
  const bool isHeld = rotate_ == Rotate::Auto && level.isStraight;
  const bool isAskew = poses_ > 4 && !isHeld;
  out.poses = Poses(isAskew ? leastBoxPose(hull) : level.pose, static_cast<int>(poses_), hull);
  if (isHeld) out.poses.hold();
  out.mass = massOf(outline);
  return out;
}

void QuickFit::add(PackItem item) {
  items_.push_back(std::move(item));
  space_.touched.resize(items_.size() * poses_);
  space_.taken.resize(items_.size() * poses_);
  forget(items_.size() - 1);
}

void QuickFit::removeLast() { items_.pop_back(); }

PackItem QuickFit::exchange(std::size_t i, PackItem item) {
  std::swap(items_[i], item);
  forget(i);
  return item;
}

/// Discards the kept cells of an item.
void QuickFit::forget(std::size_t i) {
  for (std::size_t k = i * poses_; k < (i + 1) * poses_; ++k)
    space_.touched[k].texelsPerUnit = space_.taken[k].texelsPerUnit = 0;
}

void QuickFit::hold(double side, const std::vector<std::uint32_t>& items) {
  release();
  PlaceStrategy strategy = largestFirst(items_);
  strategy.order.erase(
      std::find_first_of(strategy.order.begin(), strategy.order.end(), items.begin(), items.end()),
      strategy.order.end());
  isHeldPlaced_ = placedBy(strategy, side, kAnyArea);
  isHeld_.assign(items_.size(), 0);
  for (const std::uint32_t i : strategy.order) isHeld_[i] = 1;
  held_ = {space_.tiles[0], space_.begins[0]};
}

std::vector<std::uint8_t> QuickFit::placed(double side) { return placed(side, kAnyArea); }

std::vector<std::uint8_t> QuickFit::placed(double side, double mostMissing) {
  PlaceStrategy strategy = largestFirst(items_);
  const auto isHeld = [&](std::uint32_t i) { return i < isHeld_.size() && isHeld_[i]; };
  strategy.order.erase(std::remove_if(strategy.order.begin(), strategy.order.end(), isHeld),
                       strategy.order.end());
  for (std::size_t i = 0; i < isHeld_.size(); ++i)
    if (isHeld_[i] && !isHeldPlaced_[i]) mostMissing -= items_[i].mass.area;
  std::vector<std::uint8_t> out = placedBy(strategy, side, std::max(mostMissing, 0.0));
  for (std::size_t i = 0; i < isHeld_.size(); ++i)
    if (isHeld_[i]) out[i] = isHeldPlaced_[i];
  return out;
}

std::vector<std::uint8_t> QuickFit::placedBy(const PlaceStrategy& strategy, double side,
                                             double mostMissing) {
  PlaceOptions options;
  options.texelsPerUnit = grid_.resolution.meanSide() / side;
  options.mostMissing = mostMissing;
  options.isTileKept = true;
  if (!isHeld_.empty()) options.start = &held_;
  const Placed found = place(items_, strategy, grid_, {BitGrid()}, options, space_);
  std::vector<std::uint8_t> out;
  out.reserve(items_.size());
  for (std::size_t i = 0; i < items_.size(); ++i)
    out.push_back(items_[i].loops.points.empty() || found.spots[i].cell.isFound());
  return out;
}

double QuickFit::leastSide() {
  constexpr double kStep = 1.25, kFine = 1.01;
  constexpr int kMostSteps = 60;
  double area = 0;
  for (const PackItem& item : items_) area += item.mass.area;
  if (!(area > 0)) return 0;
  const auto fits = [&](double side) {
    const std::vector<std::uint8_t> isPlaced = placed(side, 0);
    return std::find(isPlaced.begin(), isPlaced.end(), 0) == isPlaced.end();
  };
  double low = std::sqrt(area), high = low;
  for (int i = 0; i < kMostSteps && !fits(high); ++i) {
    low = high;
    high *= kStep;
  }
  while (high > low * kFine) {
    const double middle = std::sqrt(low * high);
    (fits(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace abflat
