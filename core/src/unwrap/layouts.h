#pragma once

#include <functional>
#include <string>
#include <vector>

#include "abflat/unwrap.h"
#include "base/parallel.h"
#include "unwrap/cut_mesh.h"
#include "unwrap/laid_charts.h"
#include "unwrap/monitor.h"

namespace abflat {

/// Whether charts that come out stretched too much may be cut further.
bool canCut(const UnwrapOptions& options);

/// Flattens charts that have no layout yet, and those with pins. `tell` receives the share that is
/// done.
void flattenAll(const IdVector<ChartId, ChartConstraints>& constraints,
                const UnwrapOptions& options, ThreadPool& pool, const Monitor& monitor,
                const std::function<bool(double)>& tell, LaidCharts& charts);

/// Per chart, whether it is stretched by more than `most` and may be cut further.
IdVector<ChartId, std::uint8_t> stretchedPieces(const FlatCharts& flat,
                                                const UnwrapOptionValues& options);

/// Per chart, whether it should be split in two, since nothing else makes it valid or brings it
/// within ten times the excess that is allowed.
IdVector<ChartId, std::uint8_t> ruinedCharts(const FlatCharts& flat, double most);

/// Drops the layouts of charts that seams do not help, if more can be tried. Returns whether there
/// were any.
bool dropGivenUp(FlatCharts& flat);

void noteStretched(const CutMesh& mesh, const FlatCharts& flat, const UnwrapOptions& options,
                   std::vector<std::string>& notes);

}  // namespace abflat
