#pragma once

#include "pack/placer.h"

namespace abflat {

/// Tells on few cells and in few poses which outlines find room in a square: what packing will tell
/// in a hundred times as long.
class QuickFit {
 public:
  QuickFit(int resolution, int padding, bool rotate);

  /// `outline`: counter-clockwise and simple; empty: it takes no room.
  PackItem itemOf(const std::vector<PlanePoint>& outline) const;

  const std::vector<PackItem>& items() const { return items_; }
  void add(PackItem item);
  void removeLast();
  /// Returns the one before.
  PackItem exchange(std::size_t i, PackItem item);

  /// Per item whether it has a place in a square of that side, the largest placed first. Where
  /// those without have more than the area `mostMissing`, not all that have one are told.
  std::vector<std::uint8_t> placed(double side, double mostMissing);
  std::vector<std::uint8_t> placed(double side);

  /// Items larger than all of those are not to change until `release`: they are placed but once.
  void hold(double side, const std::vector<std::uint32_t>& items);
  void release() { isHeld_.clear(); }

  /// About the side of the least square that has room for all; 0 where they have no area.
  double leastSide();

 private:
  void forget(std::size_t i);
  std::vector<std::uint8_t> placedBy(const PlaceStrategy& strategy, double side,
                                     double mostMissing);

  PackGrid grid_;
  std::size_t poses_;
  std::vector<PackItem> items_;
  PlaceSpace space_;
  PlaceStart held_;
  std::vector<std::uint8_t> isHeld_;  ///< per item; empty: none is
  std::vector<std::uint8_t> isHeldPlaced_;
};

}  // namespace abflat
