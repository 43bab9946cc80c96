#pragma once

#include <cstdint>
#include <vector>

#include "mesh/inside_loops.h"

namespace abflat {

/// The corners of a polygon in an order in which its way crosses itself at no place, along the same
/// edges and around the same inside. That order is their own if nothing crosses; empty if none was
/// found. A corner stands for the edge that leaves it. `places`, `bounds`: see surroundings().
CornerLoop uncross(const std::vector<double>& positions, const std::vector<std::uint32_t>& places,
                   const std::vector<std::uint8_t>& bounds);

}  // namespace abflat
