#pragma once

#include <string>

#include "mesh/surface_map.h"
#include "unwrap/cuts_for_packing.h"

namespace abflat {

/// Says why charts in the atlas cover less of the tile than asked for, or why long ones leave most
/// of it empty; empty if neither is so.
std::string utilizationNote(const PackedCharts& packed, const SurfaceMap& map,
                            const UnwrapOptions& options, const AtlasReport& atlas);

}  // namespace abflat
