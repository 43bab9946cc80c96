#pragma once

#include "abflat/unwrap.h"
#include "unwrap/laid_charts.h"
#include "unwrap/open_surface.h"

namespace abflat {

/// Cuts out flat faces that the rest of their chart bends, such as the bottom of a bottle: alone
/// they lie exactly as they are, at the price of a crease. Returns the seams from before; empty if
/// there are no such faces. What is cut still consists of disks, which then have to be laid out.
Seams cutOutFlatFaces(const LaidCharts& charts, const UnwrapOptionValues& options,
                      OpenSurface& open);

/// For each chart of `before`, whether that has to be taken back: a part is not valid, or stretched
/// beyond the bounds, or together they are stretched more.
IdVector<ChartId, std::uint8_t> worseCutOut(const LaidCharts& before, const LaidCharts& now,
                                            const UnwrapOptionValues& options);

}  // namespace abflat
