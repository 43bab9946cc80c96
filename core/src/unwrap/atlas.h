#pragma once

#include <string>
#include <vector>

#include "abflat/unwrap.h"
#include "base/listener.h"
#include "unwrap/packed_charts.h"

namespace abflat {

/// Places the charts that are not fixed in the atlas. Once `listener` has
/// stopped, the status is Aborted. `formerDensity`: see PackOptions. Sets the packing fields of
/// `atlas`, and leaves its fields about packing cuts alone.
Status packAll(const PackedCharts& packed, const UnwrapOptions& options, const Listener& listener,
               AtlasReport& atlas, double formerDensity = 0);

/// Checks all charts in the atlas, rounded as the options ask or, with a note, unrounded. Charts
/// that are too small, too thin or too close to themselves for the rounding are adjusted until they
/// are not. Returns notes about that.
std::vector<std::string> checkAll(const PackedCharts& packed, const UnwrapOptions& options,
                                  AtlasReport& atlas);

}  // namespace abflat
