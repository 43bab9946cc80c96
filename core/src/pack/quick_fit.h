#pragma once

#include "pack/pack.h"
#include "pack/placer.h"

namespace abflat {

/// Estimates, on few cells and in few poses, which outlines fit into a tile. Packing takes a
/// hundred times as long to decide that. The size of a tile is the side of a square with its area.
class QuickFit {
 public:
  /// Uses resolution, padding, margin and rotation. `cells`: along that side, at least,
  /// if there are as many texels.
  QuickFit(const PackOptions& options, int cells);

  /// `outline`: counter-clockwise and simple; if empty, the item takes no room.
  PackItem itemOf(const std::vector<PlanePoint>& outline) const;

  const std::vector<PackItem>& items() const { return items_; }
  void add(PackItem item);
  void removeLast();
  /// Returns the previous item.
  PackItem exchange(std::size_t i, PackItem item);

  /// Per item, whether it has a place in a tile of that side, placing the largest first. Stops
  /// early once the items without a place exceed the area `mostMissing`; then some items that would
  /// fit are not reported.
  std::vector<std::uint8_t> placed(double side, double mostMissing);
  std::vector<std::uint8_t> placed(double side);

  /// Promises that items larger than all of these stay unchanged until `release`, so that they are
  /// placed only once.
  void hold(double side, const std::vector<std::uint32_t>& items);
  void release() { isHeld_.clear(); }

  /// Approximate side of the smallest tile that holds all items; 0 if they have no area.
  double leastSide();

 private:
  void forget(std::size_t i);
  std::vector<std::uint8_t> placedBy(const PlaceStrategy& strategy, double side,
                                     double mostMissing);

  PackGrid grid_;
  std::size_t poses_;
  Rotate rotate_;
  std::vector<PackItem> items_;
  PlaceSpace space_;
  PlaceStart held_;
  std::vector<std::uint8_t> isHeld_;  ///< per item; empty: none is
  std::vector<std::uint8_t> isHeldPlaced_;
};

}  // namespace abflat
