#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "abflat/generated/names.h"
#include "islands/check_places.h"

namespace abflat {

/// What is wrong with each triangle, decided exactly: a sum of the bits of UvFault.
std::vector<std::uint8_t> faultsOf(const PlacedTriangles& placed, std::uint32_t tiles);

/// The same for a triangle of which the rest is known.
std::uint8_t faultsAt(const double* uv, bool isOverlapping, bool isOutside);

constexpr bool hasFault(unsigned faults, UvFault fault) {
  return (faults & static_cast<unsigned>(fault)) != 0;
}

/// Counts the faces with a triangle of each fault. `face`: per triangle; those of one follow each
/// other.
template <class Report>
void countFaults(const std::vector<std::uint32_t>& face, const std::vector<std::uint8_t>& faults,
                 Report& report) {
  for (std::size_t i = 0; i < faults.size();) {
    unsigned ofFace = 0;
    const std::uint32_t own = face[i];
    for (; i < faults.size() && face[i] == own; ++i) ofFace |= faults[i];
    report.facesOverlapping += hasFault(ofFace, UvFault::Overlapping);
    report.facesFlipped += hasFault(ofFace, UvFault::Flipped);
    report.facesEmpty += hasFault(ofFace, UvFault::Empty);
    report.facesOutside += hasFault(ofFace, UvFault::Outside);
  }
}

}  // namespace abflat
