#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/arms.h"
#include "mesh/triangle_geometry.h"

namespace abflat {

/// What is around a place that a polygon visits several times: inside and outside by turns, and
/// beside each corner there, one of each.
class Surroundings {
 public:
  /// `arms` may be in any order within the same direction. `isBridge`: all corners are on bridges
  /// through the outside.
  Surroundings(std::vector<Arm> arms, const Point2& at, bool isBridge);

  /// False if inside and outside cannot be told by the directions of the edges.
  bool isClear() const { return isClear_; }
  /// Whether also no way through the place crosses another.
  bool isPlain() const { return isPlain_; }
  /// Clockwise. If it is clear, they come in and go out by turns, with the inside after those that
  /// come in.
  const std::vector<Arm>& arms() const { return arms_; }
  /// In order.
  const std::vector<std::uint32_t>& corners() const { return corners_; }

  /// Of a plain place: whether pieces of the inside meet.
  bool hasNeck() const;
  /// The part of the outside on the right of corner i of these.
  std::uint32_t right(std::size_t i) const { return right_[i]; }
  /// Per part of the outside, how far it moves. `way`: per corner, how far into the angle on its
  /// right it would move on its own.
  std::vector<Vec3> moves(const std::vector<Vec3>& way) const;

 private:
  std::uint32_t indexOf(std::uint32_t corner) const;
  bool isNeck(std::uint32_t region) const { return around_[region].size() > 1; }
  std::uint32_t outermost() const;
  bool alternate(const Clockwise& clockwise, bool isBridge);
  void findRegions(const Point2& at);
  std::vector<std::uint32_t> cycles(const std::vector<std::uint32_t>& next);

  std::vector<Arm> arms_;
  bool isClear_ = false, isPlain_ = false;
  std::vector<std::uint32_t> corners_;
  std::uint32_t regions_ = 0;
  std::vector<std::vector<std::uint32_t>> around_;  ///< per region, indices of corners
  std::vector<std::uint32_t> left_, right_;         ///< per corner: the regions beside it
  std::vector<std::uint8_t> turnsRight_;  ///< per corner: less than half a turn is on its right
};

/// Of all places that a polygon visits more than once. `places`: vertex per corner; `bounds`: per
/// corner, whether it is in a loop of the inside.
std::vector<Surroundings> surroundings(const std::vector<double>& positions,
                                       const std::vector<std::uint32_t>& places,
                                       const std::vector<std::uint8_t>& bounds);

}  // namespace abflat
