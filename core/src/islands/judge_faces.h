#pragma once

#include <cstdint>
#include <vector>

#include "abflat/generated/pack_report.h"
#include "islands/check_places.h"

namespace abflat {

/// What is wrong with each triangle, decided exactly: a sum of the bits of UvFault.
std::vector<std::uint8_t> faultsOf(const PlacedTriangles& placed, std::uint32_t tiles);

/// Counts the faces with a triangle of each fault. Triangles of a face follow each other.
void countFaults(const PlacedTriangles& placed, const std::vector<std::uint8_t>& faults,
                 PackReport& report);

}  // namespace abflat
