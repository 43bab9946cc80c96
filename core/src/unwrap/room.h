#pragma once

#include <functional>
#include <vector>

#include "abflat/unwrap.h"
#include "unwrap/laid_charts.h"
#include "unwrap/seams.h"

namespace abflat {

/// Seams that let the charts, as they lie, be packed at a higher texel density.
struct RoomCuts {
  std::vector<SurfaceCorner> halfEdges;  ///< of the open surface, one of each edge
  int count = 0;
  double length = 0;  ///< over the root of the surface's area
};

/// Whether charts may be cut for packing at all: all are to be packed, as densely as one tile
/// allows.
bool cutsForRoom(const UnwrapOptionValues& options, const FlatCharts& flat);

/// None where none are worth their length. `utilization`: that of the charts without them.
/// `goesOn` is asked now and then; when it returns false there are none.
RoomCuts findRoomCuts(const LaidCharts& charts, const OpenSurface& open,
                      const UnwrapOptionValues& options, double utilization,
                      const std::function<bool()>& goesOn);

/// Opens the surface along them, and the holes that they come to.
void addCuts(const RoomCuts& cuts, const UnwrapOptionValues& options, OpenSurface& open);

/// Closes what opens charts further than `seams` did. `before`: the charts then.
void takeBack(const ChartSet& before, const IdVector<ChartId, std::uint8_t>& isAsked,
              const Seams& seams, OpenSurface& open);

/// Whether the cuts for packing that an atlas has are worth its texel density.
bool isWorth(const AtlasReport& atlas, const UnwrapOptionValues& options);

}  // namespace abflat
