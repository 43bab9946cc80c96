#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "abflat/unwrap.h"
#include "atlas_oracle.h"

namespace abflat::fuzz {

/// As `complaint`, where charts may lie on others: each that the report says does so has to have
/// exactly the outline of the other one, and to be fine by itself, turned over if it is mirrored.
/// `chartOf`: per triangle.
std::string stackedComplaint(const AtlasTriangles& triangles,
                             const std::vector<std::uint32_t>& chartOf, const UnwrapReport& report);

}  // namespace abflat::fuzz
