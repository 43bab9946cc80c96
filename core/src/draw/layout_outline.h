#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "abflat/flatten.h"

namespace abflat {

/// Edges of a flattened disk as they are drawn.
struct LayoutOutline {
  /// Inner edges with the two vertices opposite: from, to, left, right.
  std::vector<std::array<std::uint32_t, 4>> inner;
  std::vector<std::uint32_t> boundary;  ///< vertices of the loop in order
};
LayoutOutline outlineOf(const FlattenResult& flat);

/// The edges as few trails that share no edge: each lists its vertices in order.
std::vector<std::vector<std::uint32_t>> trails(
    const std::vector<std::array<std::uint32_t, 4>>& edges, std::size_t vertexCount);

}  // namespace abflat
