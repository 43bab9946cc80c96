#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace abflat {

/// Triangles of a face that walks along edges and back again, and so has no area. None of the
/// triangles has area either, since two of its corners share a place. `places`: one per corner.
/// Corners of the result are counted from 0, and there are two triangles fewer than corners.
std::vector<std::array<std::uint32_t, 3>> foldedTriangles(const std::vector<std::uint32_t>& places);

}  // namespace abflat
