#pragma once

#include <vector>

#include "pack/free_map.h"
#include "pack/pack_grid.h"
#include "pack/placer.h"

namespace abflat {

/// In texels per unit.
struct ScaleBounds {
  double least = 1;  ///< each item takes one texel
  double most = 1;   ///< none above is possible, because of the boxes of the items and their area
  double guess = 1;  ///< what may just fit
};

ScaleBounds scaleBounds(const std::vector<PackItem>& items, const PackGrid& grid,
                        const BitGrid& taken);

}  // namespace abflat
