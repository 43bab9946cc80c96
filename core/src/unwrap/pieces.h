#pragma once

#include <vector>

#include "base/parallel.h"
#include "chart/chart_set.h"
#include "unwrap/chart.h"

namespace abflat {

/// Moves layouts to the charts that have none and are of the same form as those they were of.
void moveSame(const ChartSet& from, std::vector<FlatChart>& flatFrom, const ChartSet& to,
              std::vector<FlatChart>& flatTo);

/// Layouts for charts that have none: as they lay before they were parted from others, at a scale
/// of their own. Those that are stretched by more than `mostStretch` then, or that numbers cannot
/// keep apart where they lie, stay without one.
void takePieces(const ChartSet& before, const std::vector<FlatChart>& flatBefore,
                const ChartSet& now, double mostStretch, ThreadPool& pool,
                std::vector<FlatChart>& flat);

/// Per chart before whether one of its pieces is stretched by more than `mostStretch`, and by more
/// than all of it was.
std::vector<std::uint8_t> stretchedByCuts(const ChartSet& before,
                                          const std::vector<FlatChart>& flatBefore,
                                          const ChartSet& now, const std::vector<FlatChart>& flat,
                                          double mostStretch);

}  // namespace abflat
