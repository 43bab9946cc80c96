#pragma once

#include <vector>

#include "chart/chart_set.h"
#include "parallel.h"
#include "unwrap_chart.h"

namespace abflat {

/// Of the chart that is stretched most.
double mostStretch(const std::vector<FlatChart>& flat);

/// Moves layouts of the charts that are as they were, and of the same form, from those before.
std::vector<FlatChart> layoutsKept(const ChartSet& before, const ChartSet& now,
                                   std::vector<FlatChart>& flat);

/// Moves them back.
void giveBack(const ChartSet& before, const ChartSet& now, std::vector<FlatChart>& kept,
              std::vector<FlatChart>& flat);

/// Layouts for charts that have none: as they lay before they were parted from others, at a scale
/// of their own. Those that are stretched by more than `mostStretch` then, or that numbers cannot
/// keep apart where they lie, stay without one.
void takePieces(const ChartSet& before, const std::vector<FlatChart>& flatBefore,
                const ChartSet& now, double mostStretch, ThreadPool& pool,
                std::vector<FlatChart>& flat);

}  // namespace abflat
