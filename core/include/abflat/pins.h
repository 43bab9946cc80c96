#pragma once

#include <array>
#include <cstdint>

namespace abflat {

/// The face of a pin that needs none.
constexpr std::uint32_t kAnyFace = 0xffffffffu;

/// The position of a vertex in the layout. Vertex and face are those of the input mesh.
struct Pin {
  std::uint32_t vertex = 0;
  std::array<double, 2> uv{};
  /// A face that uses the vertex. It selects one of the vertex's texcoords if it has several, as on
  /// the two sides of a seam.
  std::uint32_t face = kAnyFace;
};

}  // namespace abflat
