#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace abflat {

/// Two triangles that have more than boundary in common, decided exactly. `uv` has 6 coordinates
/// per triangle; triangles that are not counter-clockwise are ignored.
std::optional<std::array<std::uint32_t, 2>> findOverlap(const std::vector<double>& uv);

}  // namespace abflat
