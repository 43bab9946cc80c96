#pragma once

#include <vector>

#include "base/parallel.h"
#include "unwrap/laid_charts.h"

namespace abflat {

/// Moves layouts to charts that have none and are of the same form as the layout's chart.
void moveSame(LaidCharts& from, LaidCharts& to);

/// Lays out charts that have no layout: they keep the shape they had before they were cut from
/// others, each rescaled on its own. A chart that is then stretched beyond the options' bounds, or
/// that floating point cannot keep apart where it lies, stays without a layout.
void takePieces(const LaidCharts& before, const UnwrapOptionValues& options, ThreadPool& pool,
                LaidCharts& now);

/// For each chart of `before`, whether one of its pieces is stretched beyond the options' bounds
/// and by more than the whole chart was.
IdVector<ChartId, std::uint8_t> stretchedByCuts(const LaidCharts& before, const LaidCharts& now,
                                                const UnwrapOptionValues& options);

}  // namespace abflat
