#pragma once

#include <vector>

#include "pack/scale_search.h"

namespace abflat {

/// As searchScale. Unless that gains texels, items that lie level or stand upright are turned by
/// quarters only; `items` then have fewer poses, to which the result refers.
ScaleSearch searchTidyScale(std::vector<PackItem>& items, const PackGrid& grid,
                            const BitGrid& taken, const ScaleOptions& options);

}  // namespace abflat
