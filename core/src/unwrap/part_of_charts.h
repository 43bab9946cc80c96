#pragma once

#include <cstdint>

#include "seam/extract_charts.h"
#include "unwrap/laid_charts.h"
#include "unwrap/open_surface.h"

namespace abflat {

/// The surface of the wanted charts, in an order that depends on its shape alone. It is open along
/// their outlines, unless all charts are wanted.
SeamPart partOfCharts(const LaidCharts& charts, const OpenSurface& open,
                      const IdVector<ChartId, std::uint8_t>& isWanted);

}  // namespace abflat
