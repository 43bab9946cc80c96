#include "mesh/surroundings.h"

#include <algorithm>
#include <utility>

#include "base/ids.h"
#include "base/stable_order.h"
#include "exact/orientation.h"
#include "mesh/project_polygon.h"
#include "mesh/vec3_sum.h"

namespace abflat {

Surroundings::Surroundings(std::vector<Arm> arms, const Point2& at, bool isBridge)
    : arms_(std::move(arms)) {
  for (const Arm& arm : arms_)
    if (arm.isOut) corners_.push_back(arm.corner);
  std::sort(corners_.begin(), corners_.end());
  isClear_ = !arms_.empty() && alternate(Clockwise{at}, isBridge);
  if (isClear_) findRegions(at);
}

void Surroundings::findRegions(const Point2& at) {
  const std::size_t n = corners_.size();
  std::vector<std::uint32_t> nextLeft(n), nextRight(n), orderIn(n), orderOut(n);
  for (std::uint32_t i = 0; i < arms_.size(); ++i) {
    const std::uint32_t k = indexOf(arms_[i].corner);
    const std::uint32_t next = indexOf(arms_[i + 1 < arms_.size() ? i + 1 : 0].corner);
    (arms_[i].isOut ? nextRight : nextLeft)[k] = next;
    (arms_[i].isOut ? orderOut : orderIn)[k] = i;
  }
  left_ = cycles(nextLeft);
  right_ = cycles(nextRight);
  isPlain_ = regions_ == n + 1;
  for (std::uint32_t k = 0; k < n; ++k) {
    const Point2 &in = arms_[orderIn[k]].end, &out = arms_[orderOut[k]].end;
    const int side = orientation(at.data(), in.data(), out.data());
    const bool isSpike = side == 0 && Clockwise{at}.compare(in, out) == 0;
    turnsRight_.push_back(isSpike ? orderOut[k] < orderIn[k] : side >= 0);
  }
}

bool Surroundings::hasNeck() const {
  return std::any_of(left_.begin(), left_.end(), [&](std::uint32_t r) { return isNeck(r); });
}

/// Where less than half a turn is on the right of a corner, all that lies there moves into that
/// angle. So no edge of one part comes to cross that of another.
std::vector<Vec3> Surroundings::moves(const std::vector<Vec3>& way) const {
  std::vector<Vec3> out(regions_, Vec3{});
  std::vector<std::uint8_t> isKnown(regions_, 0);
  std::vector<std::uint32_t> todo{right_[0]};
  isKnown[right_[0]] = 1;
  while (!todo.empty()) {
    const std::uint32_t region = todo.back();
    todo.pop_back();
    for (const std::uint32_t k : around_[region]) {
      if (!isNeck(left_[k])) continue;
      const bool isRight = region == right_[k];
      const std::uint32_t other = isRight ? left_[k] : right_[k];
      if (isKnown[other]) continue;
      isKnown[other] = 1;
      out[other] = turnsRight_[k] ? sum(out[region], way[k], isRight ? -1 : 1) : out[region];
      todo.push_back(other);
    }
  }
  const Vec3 still = out[outermost()];
  for (Vec3& move : out) move = sum(move, still, -1);
  return out;
}

std::uint32_t Surroundings::indexOf(std::uint32_t corner) const {
  const auto found = std::lower_bound(corners_.begin(), corners_.end(), corner);
  return static_cast<std::uint32_t>(found - corners_.begin());
}

/// The region that no angle of less than half a turn contains, among those that are necks or beside
/// one.
std::uint32_t Surroundings::outermost() const {
  for (std::uint32_t region = 0; region < regions_; ++region) {
    const std::vector<std::uint32_t>& around = around_[region];
    const bool isOutside = region == right_[around[0]];
    if (!isOutside && !isNeck(region)) continue;
    const auto isWithin = [&](std::uint32_t k) {
      return isNeck(left_[k]) && isOutside == (turnsRight_[k] != 0);
    };
    if (std::none_of(around.begin(), around.end(), isWithin)) return region;
  }
  return right_[0];
}

/// Numbers the cycles of a permutation as regions.
std::vector<std::uint32_t> Surroundings::cycles(const std::vector<std::uint32_t>& next) {
  std::vector<std::uint32_t> out(next.size(), kNone);
  for (std::uint32_t first = 0; first < next.size(); ++first) {
    if (out[first] != kNone) continue;
    around_.emplace_back();
    for (std::uint32_t k = first; out[k] == kNone; k = next[k]) {
      out[k] = regions_;
      around_.back().push_back(k);
    }
    ++regions_;
  }
  return out;
}

/// Sorts arms in the same direction. False if arms cannot come in and go out by turns.
bool Surroundings::alternate(const Clockwise& clockwise, bool isBridge) {
  struct Direction {
    std::size_t begin, end;
    std::array<std::vector<Arm>, 2> arms;  ///< in, out
  };
  std::vector<Direction> directions;
  for (std::size_t i = 0; i < arms_.size(); ++i) {
    if (i == 0 || clockwise.compare(arms_[i - 1].end, arms_[i].end) != 0)
      directions.push_back({i, i, {}});
    directions.back().end = i + 1;
    directions.back().arms[arms_[i].isOut].push_back(arms_[i]);
  }
  std::size_t start = 0;
  bool isOut = !isBridge;  // if each direction has as many of one kind as of the other
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto& [in, out] = directions[i].arms;
    if (in.size() == out.size()) continue;
    start = i;
    isOut = out.size() > in.size();
  }
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Direction& direction = directions[(start + i) % directions.size()];
    std::array<std::size_t, 2> used{0, 0};
    for (std::size_t k = direction.begin; k < direction.end; ++k, isOut = !isOut) {
      if (used[isOut] == direction.arms[isOut].size()) return false;
      arms_[k] = direction.arms[isOut][used[isOut]++];
    }
  }
  return true;
}

std::vector<Surroundings> surroundings(const std::vector<double>& positions,
                                       const std::vector<std::uint32_t>& places,
                                       const std::vector<std::uint8_t>& bounds) {
  const std::vector<Point2> points = projectPolygon(positions, places.data(), places.size());
  const std::vector<std::uint32_t> order = stableOrder(
      places.size(), [&](std::uint32_t a, std::uint32_t b) { return places[a] < places[b]; });
  std::vector<Surroundings> out;
  for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
    bool isBridge = true;
    for (; end < order.size() && places[order[end]] == places[order[i]]; ++end)
      isBridge = isBridge && !bounds[order[end]];
    const std::uint32_t* first = &order[i];
    if (end - i > 1)
      out.emplace_back(armsAround(points, first, first + (end - i)), points[*first], isBridge);
  }
  return out;
}

}  // namespace abflat
