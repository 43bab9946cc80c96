#pragma once

#include "base/listener.h"
#include "base/parallel.h"
#include "pack/placer.h"

namespace abflat {

struct ScaleOptions {
  double work = 0;    ///< see PackOptions
  double former = 0;  ///< see PackOptions; a scale
  ThreadPool* pool = nullptr;
  Listener listener;
};

struct ScaleSearch {
  Placed best;  ///< TooMany if not even one texel per item fits
  double texelsPerUnit = 0;
  int tries = 0;
  double work = 0;  ///< of all tries together
};

/// Finds the largest scale it can at which all items fit one tile. `taken`: cells that are already
/// taken, or an empty grid. The result does not depend on threads.
ScaleSearch searchScale(const std::vector<PackItem>& items, const PackGrid& grid,
                        const BitGrid& taken, const ScaleOptions& options);

}  // namespace abflat
