#pragma once

#include <functional>
#include <vector>

#include "abflat/unwrap.h"
#include "unwrap/packed_charts.h"

namespace abflat {

/// Places the charts that are not fixed in the atlas. `tell` hears which share is done; when it
/// returns false the status is Aborted. Sets what `atlas` says of packing, and leaves what it says
/// of cuts for it.
Status packAll(const PackedCharts& packed, const UnwrapOptionValues& options,
               const std::function<bool(double)>& tell, AtlasReport& atlas);

/// Checks all charts in the atlas, rounded as the options ask for or, with a note, as they are.
/// Those that are too small or too thin for that are made so that they are not, with a note.
void checkAll(const PackedCharts& packed, const UnwrapOptions& options, UnwrapReport& report);

}  // namespace abflat
