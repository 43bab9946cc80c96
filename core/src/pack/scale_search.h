#pragma once

#include "pack/placer.h"

namespace abflat {

struct ScaleSearch {
  Placed best;  ///< fits, unless cancelled
  double texelsPerUnit = 0;
  int tries = 0;
};

/// The largest scale at which all items fit one tile, up to half a percent. They must fit when each
/// takes one texel.
ScaleSearch searchScale(const std::vector<PackItem>& items, const std::vector<std::uint32_t>& order,
                        const PackGrid& grid, ThreadPool* pool,
                        const std::function<bool(double)>& progress);

/// No scale above is possible: area of the items grown by the padding, and their boxes.
double largestScale(const std::vector<PackItem>& items, const PackGrid& grid);

}  // namespace abflat
