#pragma once

#include "chart/disk_chart.h"

namespace abflat {

/// What the outline has to conform to.
struct OutlineRules {
  StraightPlaces straight;
  BoundaryBounds bounds;  ///< 2 or more: any angle is allowed; empty: no bounds
  /// Radians: distance that angles keep from their bounds where that costs little. They start out
  /// this far away.
  double margin = 0;

  bool isEmpty() const { return straight.empty() && bounds.empty(); }
};

}  // namespace abflat
