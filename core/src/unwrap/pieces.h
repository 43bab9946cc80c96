#pragma once

#include <vector>

#include "base/parallel.h"
#include "unwrap/laid_charts.h"

namespace abflat {

/// Moves layouts to the charts that have none and are of the same form as those they were of.
void moveSame(LaidCharts& from, LaidCharts& to);

/// Layouts for charts that have none: as they lay before they were parted from others, at a scale
/// of their own. Those that are stretched by more than `mostStretch` then, or that numbers cannot
/// keep apart where they lie, stay without one.
void takePieces(const LaidCharts& before, double mostStretch, ThreadPool& pool, LaidCharts& now);

/// Per chart before whether one of its pieces is stretched by more than `mostStretch`, and by more
/// than all of it was.
IdVector<ChartId, std::uint8_t> stretchedByCuts(const LaidCharts& before, const LaidCharts& now,
                                                double mostStretch);

}  // namespace abflat
