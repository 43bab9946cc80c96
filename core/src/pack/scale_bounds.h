#pragma once

#include <vector>

#include "pack/free_map.h"
#include "pack/pack_grid.h"
#include "pack/placer.h"

namespace abflat {

/// In texels per unit length.
struct ScaleBounds {
  double least = 1;  ///< each item takes one texel
  double most = 1;   ///< nothing above is possible, given the items' boxes and area
  double guess = 1;  ///< may just fit
};

ScaleBounds scaleBounds(const std::vector<PackItem>& items, const PackGrid& grid,
                        const BitGrid& taken);

}  // namespace abflat
