#pragma once

#include "base/parallel.h"
#include "unwrap/open_surface.h"

namespace abflat {

/// Predicts the scale again for charts that seams have changed.
void expectScale(const ChartSet& set, const IdVector<ChartId, std::uint8_t>& isAsked,
                 ThreadPool& pool, OpenSurface& open);

}  // namespace abflat
