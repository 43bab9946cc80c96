#pragma once

#include <string>
#include <vector>

#include "abflat/unwrap.h"
#include "base/listener.h"
#include "base/parallel.h"
#include "unwrap/cut_mesh.h"
#include "unwrap/laid_charts.h"

namespace abflat {

/// Whether charts that come out stretched too much may be cut further.
bool canCut(const UnwrapOptions& options);

/// Flattens charts that have no layout yet, and those with pins. Once `listener` has
/// stopped, charts stay without a layout.
void flattenAll(const IdVector<ChartId, ChartConstraints>& constraints,
                const UnwrapOptions& options, ThreadPool& pool, const Listener& listener,
                LaidCharts& charts);

/// Per chart, whether it is stretched by more than `most` and may be cut further.
IdVector<ChartId, std::uint8_t> stretchedPieces(const ChartSet& set, const FlatCharts& flat,
                                                const UnwrapOptionValues& options);

/// Per chart, whether it should be split in two, since nothing else makes it valid or brings it
/// within ten times the excess that is allowed.
IdVector<ChartId, std::uint8_t> ruinedCharts(const ChartSet& set, const FlatCharts& flat,
                                             double most);

/// Drops the layouts of charts that seams do not help, if more can be tried. Returns whether there
/// were any.
bool dropGivenUp(FlatCharts& flat);

void noteStretched(const CutMesh& mesh, const FlatCharts& flat, const UnwrapOptions& options,
                   std::vector<std::string>& notes);

}  // namespace abflat
