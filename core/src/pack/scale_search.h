#pragma once

#include "base/parallel.h"
#include "pack/placer.h"

namespace abflat {

struct ScaleOptions {
  double work = 0;  ///< see PackOptions
  ThreadPool* pool = nullptr;
  /// Told a rough 0..1 from the calling thread; false cancels.
  std::function<bool(double)> progress;
};

struct ScaleSearch {
  Placed best;  ///< TooMany when not even one texel for each item fits
  double texelsPerUnit = 0;
  int tries = 0;
  double work = 0;  ///< of them together
};

/// The largest scale that is found at which all items fit one tile. `taken`: cells that others
/// have, or an empty grid.
/// Threads do not change the result.
ScaleSearch searchScale(const std::vector<PackItem>& items, const PackGrid& grid,
                        const BitGrid& taken, const ScaleOptions& options);

}  // namespace abflat
