#pragma once

#include <vector>

#include "abflat/flatten.h"
#include "boundary/auto_bounds.h"
#include "boundary/chart_flattener.h"
#include "pin/pinned_layout.h"

namespace abflat {

/// `FlattenOptions::memory` in bytes.
std::uint64_t allowedBytes(double megabytes);

/// The goal for t = auto: bounds are free, and the rest follows from that.
OutlineGoal automaticGoal(const BoundaryBounds& t);

/// What the options ask for besides the bounds.
OutlineGoal outlineGoal(const FlattenOptionValues& options, const BoundaryBounds& t);

/// Flattens one chart with the requested outline, as far as that is possible.
Attempt flattenChart(ChartFlattener& flattener, const OutlineGoal& goal, const Effort& effort = {});

/// Moves the attempt's layout to its pins, and checks and measures it again. Does nothing without
/// pins.
void pin(ChartFlattener& flattener, const std::vector<ChartPin>& pins, const PinOptions& options,
         Attempt& attempt);

/// The layout in the mesh's unit, a power of two. If the scaling loses digits, the attempt becomes
/// the rounded layout, measured again; otherwise everything known about it still holds digit for
/// digit.
std::vector<double> inMeshUnit(const DiskChart& chart, Attempt& attempt);

}  // namespace abflat
