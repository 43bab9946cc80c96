#pragma once

#include <functional>
#include <string>
#include <vector>

#include "abflat/unwrap.h"
#include "base/parallel.h"
#include "unwrap/laid_charts.h"
#include "unwrap/monitor.h"

namespace abflat {

/// Whether charts that come out stretched too much may be cut further.
bool canCut(const UnwrapOptions& options);

/// Flattens charts that have no layout yet, and those with pins. `tell` receives the share that is
/// done.
void flattenAll(const IdVector<ChartId, ChartWishes>& wishes, const UnwrapOptions& options,
                ThreadPool& pool, const Monitor& monitor, const std::function<bool(double)>& tell,
                LaidCharts& charts);

/// Whether the chart is stretched more than seams should allow.
bool isStretched(const FlatChart& chart, double most);

/// Per chart, whether it is stretched by more than `most` and may be cut further.
IdVector<ChartId, std::uint8_t> stretchedPieces(const FlatCharts& flat, double most);

/// Drops the layouts of tangled charts that seams do not help. Returns whether there were any.
bool dropTangled(FlatCharts& flat);

void noteStretched(const FlatCharts& flat, const UnwrapOptions& options,
                   std::vector<std::string>& notes);

}  // namespace abflat
