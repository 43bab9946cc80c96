#pragma once

#include <array>
#include <cstdint>

namespace abflat {

/// Of a pin that needs no face.
constexpr std::uint32_t kAnyFace = 0xffffffffu;

/// The place of a vertex in the layout. Vertex and face are those of the input mesh.
struct Pin {
  std::uint32_t vertex = 0;
  std::array<double, 2> uv{};
  /// One that uses the vertex: tells which of its texcoords is meant where it has several, on both
  /// sides of a seam.
  std::uint32_t face = kAnyFace;
};

}  // namespace abflat
