#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace abflat {

/// Triangles of a face that walks along edges and back again, so that it has no area: none of them
/// has any, as two of its corners are at one place. `places` per corner; corners of the result are
/// counted from 0, and there are two triangles less than corners.
std::vector<std::array<std::uint32_t, 3>> foldedTriangles(const std::vector<std::uint32_t>& places);

}  // namespace abflat
