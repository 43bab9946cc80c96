#pragma once

#include <functional>
#include <vector>

#include "abflat/unwrap.h"
#include "pack/pack.h"
#include "parallel.h"
#include "unwrap_chart.h"

namespace abflat {

/// Places the charts that are not fixed in the atlas. `tell` hears which share is done; when it
/// returns false the status is Aborted.
Status packAll(const std::vector<DiskChart>& charts, const UnwrapOptionValues& options,
               ThreadPool& pool, const std::function<bool(double)>& tell,
               std::vector<FlatChart>& flat, Packing& packing, AtlasReport& atlas);

/// Checks all charts in the atlas, rounded as the options ask for or, with a note, as they are.
void checkAll(const std::vector<DiskChart>& charts, const UnwrapOptions& options,
              const Packing& packing, ThreadPool& pool, std::vector<FlatChart>& flat,
              UnwrapReport& report);

}  // namespace abflat
