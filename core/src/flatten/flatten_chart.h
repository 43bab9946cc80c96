#pragma once

#include <vector>

#include "abflat/flatten.h"
#include "boundary/auto_bounds.h"
#include "boundary/chart_flattener.h"
#include "pin/pinned_layout.h"

namespace abflat {

/// `FlattenOptions::memory` in bytes.
std::uint64_t allowedBytes(double megabytes);

/// Fewer than asked for where a mesh is so small that starting a thread takes longer than it saves.
unsigned usefulThreads(int wanted, std::size_t faces);

/// With bounds that are free, and what follows from t = auto.
OutlineGoal automaticGoal(const BoundaryBounds& t);

/// What the options ask for beside the bounds.
OutlineGoal outlineGoal(const FlattenOptionValues& options, const BoundaryBounds& t);

/// One chart with the outline that is asked for, as far as that can be.
Attempt flattenChart(ChartFlattener& flattener, const OutlineGoal& goal, const Effort& effort = {});

/// Moves the attempt's layout to where its pins are, and checks and measures it anew. Without pins
/// it stays.
void pin(ChartFlattener& flattener, const std::vector<ChartPin>& pins, const PinOptions& options,
         Attempt& attempt);

/// The layout in the mesh's unit, a power of two. Where that costs digits, the attempt becomes the
/// layout that is left, measured anew; elsewhere all that is known about it holds digit by digit.
std::vector<double> inMeshUnit(const DiskChart& chart, Attempt& attempt);

}  // namespace abflat
