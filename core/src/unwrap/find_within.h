#pragma once

#include "unwrap/open_surface.h"

namespace abflat {

/// Finds new seams within the wanted charts of `surface`, starting from those that were found
/// before. False if nothing has changed.
bool findWithin(const CutSurface& surface, const IdVector<CutChartId, std::uint8_t>& isWanted,
                SeamOptions options, OpenSurface& open, SeamReport& found);

}  // namespace abflat
