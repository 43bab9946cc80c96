#pragma once

#include <functional>
#include <vector>

#include "abflat/unwrap.h"
#include "base/parallel.h"
#include "chart/chart_set.h"
#include "pack/pack.h"
#include "unwrap/chart.h"

namespace abflat {

/// Places the charts that are not fixed in the atlas. `unit`: what a length of 1 is in the mesh.
/// `tell` hears which share is done; when it returns false the status is Aborted. Sets what
/// `atlas` says of packing, and leaves what it says of cuts for it.
Status packAll(const ChartSet& charts, const UnwrapOptionValues& options, double unit,
               ThreadPool& pool, const std::function<bool(double)>& tell, FlatCharts& flat,
               Packing& packing, AtlasReport& atlas);

/// Checks all charts in the atlas, rounded as the options ask for or, with a note, as they are.
/// Those that are too small or too thin for that are made so that they are not, with a note.
void checkAll(const ChartSet& charts, const UnwrapOptions& options, double unit, ThreadPool& pool,
              FlatCharts& flat, Packing& packing, UnwrapReport& report);

}  // namespace abflat
