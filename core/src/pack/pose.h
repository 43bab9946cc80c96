#pragma once

#include <vector>

#include "pack/outline.h"

namespace abflat {

/// A rotation, and the box of the rotated shape.
struct Pose {
  double cos = 1, sin = 0;
  double minX = 0, minY = 0;
  double width = 0, height = 0;
  int quarter = 0;     ///< quarter turns from the pose whose cells it shares
  bool snaps = false;  ///< the sides of the box lie on borders of texels

  PlanePoint rotated(PlanePoint p) const { return {cos * p.x - sin * p.y, sin * p.x + cos * p.y}; }
};

/// Rotates by `angle` / `of` of a full turn; exact for quarters.
Pose turned(const Pose& base, int angle, int of, const std::vector<PlanePoint>& hull);

/// Full turns in equal steps: of 1 pose, or of a multiple of 4. Poses from the second quarter on
/// are exactly those of the first, rotated, so only the first quarter is kept.
class Poses {
 public:
  Poses() = default;
  Poses(const Pose& base, int count, const std::vector<PlanePoint>& hull);

  /// Adds the quarter turns of a pose; in each quarter it comes first.
  void addFirst(const Pose& pose, const std::vector<PlanePoint>& hull);

  /// Lets the sides of the first pose of each quarter lie on borders of texels.
  void snap() { first_[0].snaps = true; }

  /// Keeps only the first pose of each quarter; the others stand for it.
  void hold() { isHeld_ = true; }
  bool isHeld() const { return isHeld_; }
  /// The pose that this one stands for.
  std::size_t kept(std::size_t i) const { return isHeld_ ? i - i % first_.size() : i; }

  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  /// Number of poses in a quarter of a turn, of which only the first one may be the added one.
  std::size_t perQuarter() const { return first_.size(); }
  bool hasAdded() const { return hasAdded_; }
  Pose operator[](std::size_t i) const;
  /// The pose from which the steps begin.
  const Pose& base() const { return first_[hasAdded_ ? 1 : 0]; }

 private:
  std::vector<Pose> first_;
  std::uint32_t count_ = 0;
  bool hasAdded_ = false, isHeld_ = false;
};

/// The rotation with the smallest box area; the box is wider than high, and the heavier part at its
/// left, so that it is the same however the shape was turned.
Pose leastBoxPose(const std::vector<PlanePoint>& hull);

}  // namespace abflat
