#pragma once

#include <functional>
#include <vector>

#include "boundary/auto_bounds.h"
#include "pin/pinned_layout.h"

namespace abflat {

struct RefineWishes {
  double balance = 0;     ///< nothing is done for 0
  BoundaryBounds bounds;  ///< empty: any
  std::vector<ChartPin> pins;
  std::uint64_t allowedBytes = std::numeric_limits<std::uint64_t>::max();
  ThreadPool* pool = nullptr;
  std::function<bool()> onStep;  ///< hears of each step; false: no further one
  bool mayBeRough = false;       ///< angles are only to begin refining from
};

/// A chart flattened as flattenChart() does, and refined. A free boundary that crosses itself may
/// well no longer do so once lengths are kept: that is tried before it is untangled.
Attempt flattenAndRefine(ChartFlattener& flattener, const OutlineGoal& goal, const Effort& effort,
                         const RefineWishes& wishes);

/// Trades angles of a valid layout for lengths, and checks and measures it anew. What was asked for
/// stays: pins, straight runs and bounds.
void refineChart(ChartFlattener& flattener, const RefineWishes& wishes, Attempt& attempt);

}  // namespace abflat
