#include "pack/pose.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/portable_math.h"

namespace abflat {
namespace {

void measure(Pose& pose, const std::vector<PlanePoint>& hull) {
  if (hull.empty()) return;
  PlanePoint least = pose.rotated(hull[0]), most = least;
  for (const PlanePoint& p : hull) {
    const PlanePoint q = pose.rotated(p);
    least = {std::min(least.x, q.x), std::min(least.y, q.y)};
    most = {std::max(most.x, q.x), std::max(most.y, q.y)};
  }
  pose.minX = least.x;
  pose.minY = least.y;
  pose.width = most.x - least.x;
  pose.height = most.y - least.y;
}

Pose quarterTurned(const Pose& pose) {
  Pose out;
  out.cos = -pose.sin;
  out.sin = pose.cos;
  out.minX = -(pose.minY + pose.height);
  out.minY = pose.minX;
  out.width = pose.height;
  out.height = pose.width;
  out.quarter = pose.quarter + 1;
  out.snaps = pose.snaps;
  return out;
}

/// Of the poses that differ by half a turn, or by quarters if the box is a square, the one with the
/// heavier part of the hull at its left.
Pose heavyAtLeft(const Pose& pose, double alike, const std::vector<PlanePoint>& hull) {
  const PlanePoint center = pose.rotated(massOf(hull).center);
  const double size = std::max(pose.width, pose.height), least = (1 - alike) * size;
  double dx = center.x - pose.minX - pose.width / 2, dy = center.y - pose.minY - pose.height / 2;
  int quarters = 0;
  const bool isSquare = pose.height >= pose.width * alike;
  const auto isAtLeft = [&] {
    if (!isSquare) return dx < -least || (dx < least && dy < least);
    return dx < least && std::abs(dy) <= std::abs(dx) + least;
  };
  for (; quarters < 4 && !isAtLeft(); quarters += isSquare ? 1 : 2) {
    const PlanePoint now{dx, dy};
    dx = isSquare ? -now.y : -now.x;
    dy = isSquare ? now.x : -now.y;
  }
  return quarters % 4 == 0 ? pose : turned(pose, quarters, 4, hull);
}

}  // namespace

Pose turned(const Pose& base, int angle, int of, const std::vector<PlanePoint>& hull) {
  static constexpr int kCos[] = {1, 0, -1, 0};
  portable::SinCos by{};
  if (4 * angle % of == 0) {
    const int quarter = 4 * angle / of % 4;
    by.cos = kCos[quarter];
    by.sin = kCos[(quarter + 3) % 4];
  } else {
    by = portable::sinCos(2 * kPi * angle / of);
  }
  Pose out;
  out.cos = base.cos * by.cos - base.sin * by.sin;
  out.sin = base.sin * by.cos + base.cos * by.sin;
  measure(out, hull);
  return out;
}

Poses::Poses(const Pose& base, int count, const std::vector<PlanePoint>& hull)
    : count_(static_cast<std::uint32_t>(count)) {
  first_.reserve((count_ + 3) / 4);
  for (int k = 0; 4 * k < count; ++k) first_.push_back(turned(base, k, count, hull));
}

void Poses::addFirst(const Pose& pose, const std::vector<PlanePoint>& hull) {
  first_.insert(first_.begin(), turned(pose, 0, 4, hull));
  count_ += 4;
  hasAdded_ = true;
}

Pose Poses::operator[](std::size_t i) const {
  Pose out = first_[kept(i) % first_.size()];
  for (std::size_t k = first_.size(); k <= i; k += first_.size()) out = quarterTurned(out);
  return out;
}

Pose leastBoxPose(const std::vector<PlanePoint>& hull) {
  Pose best;
  measure(best, hull);
  if (hull.size() < 2) return best;
  // One side of the box lies along an edge of the hull. Among equal boxes the first is taken, so
  // that rounding does not decide.
  constexpr double kAlike = 1 - 1e-9;
  double least = -1;
  const std::size_t n = hull.size();
  std::size_t right = 0, top = 0, left = 0;
  const auto along = [&](std::size_t i, PlanePoint d) {
    return hull[i % n].x * d.x + hull[i % n].y * d.y;
  };
  for (std::size_t i = 0; i < n; ++i) {
    const PlanePoint from = hull[i], to = hull[(i + 1) % n];
    const double length = portable::hypot(to.x - from.x, to.y - from.y);
    if (!(length > 0)) continue;
    const PlanePoint d{(to.x - from.x) / length, (to.y - from.y) / length}, normal{-d.y, d.x};
    const PlanePoint back{-d.x, -d.y};
    right = std::max(right, i);
    while (right < i + n && along(right + 1, d) > along(right, d)) ++right;
    top = std::max(top, right);
    while (top < i + n && along(top + 1, normal) > along(top, normal)) ++top;
    left = std::max(left, top);
    while (left < i + n && along(left + 1, back) > along(left, back)) ++left;
    const double width = along(right, d) - along(left, d);
    const double height = along(top, normal) - along(i, normal);
    const double area = width * height;
    if (least >= 0 && !(area < least * kAlike)) continue;
    least = area;
    best.cos = d.x;
    best.sin = -d.y;
  }
  measure(best, hull);
  if (!(best.width >= best.height * kAlike)) best = turned(best, 1, 4, hull);
  return heavyAtLeft(best, kAlike, hull);
}

}  // namespace abflat
