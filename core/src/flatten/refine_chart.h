#pragma once

#include <vector>

#include "base/listener.h"
#include "boundary/auto_bounds.h"
#include "pin/pinned_layout.h"

namespace abflat {

struct RefineConstraints {
  double balance = 0;     ///< 0 turns refining off
  BoundaryBounds bounds;  ///< empty: no bounds
  std::vector<ChartPin> pins;
  std::uint64_t allowedBytes = std::numeric_limits<std::uint64_t>::max();
  ThreadPool* pool = nullptr;
  Listener listener;        ///< told of each step
  bool mayBeRough = false;  ///< angles are only a starting point for refining
};

/// Flattens a chart like flattenChart(), and refines it. A free boundary that crosses itself may
/// stop doing so once lengths are kept, so refining is tried before untangling.
Attempt flattenAndRefine(ChartFlattener& flattener, const OutlineGoal& goal, const Effort& effort,
                         const RefineConstraints& constraints);

/// Trades angles of a valid layout for lengths, and checks and measures it again. Pins, straight
/// runs and bounds that were asked for are kept.
void refineChart(ChartFlattener& flattener, const RefineConstraints& constraints, Attempt& attempt);

}  // namespace abflat
