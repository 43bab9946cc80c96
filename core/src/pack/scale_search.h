#pragma once

#include "pack/placer.h"
#include "parallel.h"

namespace abflat {

struct ScaleSearch {
  Placed best;  ///< TooMany when not even one texel for each item fits
  double texelsPerUnit = 0;
  int tries = 0;
};

/// The largest scale that is found at which all items fit one tile. `tile`: what others have taken.
/// `progress` is told a rough 0..1 from the calling thread; false cancels. Threads do not change
/// the result.
ScaleSearch searchScale(const std::vector<PackItem>& items, const PackGrid& grid,
                        const FreeMap& tile, ThreadPool* pool,
                        const std::function<bool(double)>& progress);

}  // namespace abflat
