#pragma once

#include <vector>

#include "abflat/unwrap.h"
#include "base/listener.h"
#include "unwrap/open_surface.h"
#include "unwrap/packed_charts.h"

namespace abflat {

/// Seams that let the charts be packed at a higher texel density, in their present layout.
struct CutsForPacking {
  std::vector<SurfaceCorner> halfEdges;  ///< of the open surface, one of each edge
  int count = 0;
  double length = 0;  ///< divided by the root of the surface's area
};

/// Which charts may be cut for packing.
enum class CutMode { None, Long, All };

/// None unless all charts are to be packed, as densely as one tile allows, and nothing but seams
/// and straight lines limits how they are stretched. Specks, which find a place between the others,
/// do not count. `cuts`: how many of the charts come from cuts.
CutMode cutModeOf(const UnwrapOptions& options, const FlatCharts& flat, std::size_t cuts);

/// Finds cuts that are worth their length; empty if there are none. `utilization`: that of the
/// charts without cuts. If `listener` stops, the result is incomplete.
CutsForPacking findCutsForPacking(const PackedCharts& packed, const OpenSurface& open,
                                  const UnwrapOptions& options, double utilization,
                                  const Listener& listener);

/// Opens the surface along the cuts, and the holes that they reach.
void addCuts(const CutsForPacking& cuts, const UnwrapOptionValues& options, OpenSurface& open);

/// Gives the charts that are asked for the seams back that they had: cuts are closed, and what was
/// joined is cut again. `before`: the charts with `seams`.
void takeBack(const ChartSet& before, const IdVector<ChartId, std::uint8_t>& isAsked,
              const Seams& seams, OpenSurface& open);

/// Whether the gain in texel density is worth the packing cuts of the atlas.
bool isWorth(const AtlasReport& atlas, double seamCost, const UnwrapOptionValues& options);

}  // namespace abflat
