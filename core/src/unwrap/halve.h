#pragma once

#include "abflat/unwrap.h"
#include "unwrap/open_surface.h"

namespace abflat {

/// Splits charts in two, whatever is predicted, and adds those to `isWhole` that cannot be split.
/// False if none can be.
bool halve(const ChartSet& set, const IdVector<ChartId, std::uint8_t>& isAsked,
           const UnwrapOptionValues& options, OpenSurface& open,
           IdVector<ChartId, std::uint8_t>& isWhole);

}  // namespace abflat
