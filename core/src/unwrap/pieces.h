#pragma once

#include <vector>

#include "base/parallel.h"
#include "chart/chart_set.h"
#include "unwrap/chart.h"

namespace abflat {

/// Moves layouts to the charts that have none and are of the same form as those they were of.
void moveSame(const ChartSet& from, FlatCharts& flatFrom, const ChartSet& to, FlatCharts& flatTo);

/// Layouts for charts that have none: as they lay before they were parted from others, at a scale
/// of their own. Those that are stretched by more than `mostStretch` then, or that numbers cannot
/// keep apart where they lie, stay without one.
void takePieces(const ChartSet& before, const FlatCharts& flatBefore, const ChartSet& now,
                double mostStretch, ThreadPool& pool, FlatCharts& flat);

/// Per chart before whether one of its pieces is stretched by more than `mostStretch`, and by more
/// than all of it was.
IdVector<ChartId, std::uint8_t> stretchedByCuts(const ChartSet& before,
                                                const FlatCharts& flatBefore, const ChartSet& now,
                                                const FlatCharts& flat, double mostStretch);

}  // namespace abflat
