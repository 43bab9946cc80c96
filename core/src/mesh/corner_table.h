#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangulate.h"

namespace abflat {

constexpr std::uint32_t kNone = 0xffffffffu;

/// Corner c = 3f + k; half-edge h = 3f + k runs from the vertex of corner h to that of
/// nextCorner(h).
inline std::uint32_t nextCorner(std::uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; }
inline std::uint32_t prevCorner(std::uint32_t c) { return c % 3 == 0 ? c + 2 : c - 1; }

/// An edge that stops the mesh from being an oriented manifold, with its first two or three faces.
struct BadEdge {
  std::uint32_t v0 = kNone, v1 = kNone;
  std::uint32_t faceCount = 0;
  std::array<std::uint32_t, 2> faces{kNone, kNone};  ///< input faces
};

/// Connectivity of a triangulation. Bad edges have no twins: the surface is cut open along them.
struct CornerTable {
  std::vector<std::uint32_t> vertex;  ///< input vertex per corner, size 3T
  std::vector<std::uint32_t> twin;    ///< opposite half-edge, kNone on the boundary, size 3T
  std::vector<BadEdge> nonManifold;   ///< more than two faces
  std::vector<BadEdge> misoriented;   ///< two faces that run in the same direction

  std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(vertex.size() / 3); }
};

/// Polygon edges are matched by their two vertices, diagonals only inside their own face, so a
/// diagonal never becomes a non-manifold edge. Linear in the mesh apart from sorting within one
/// vertex.
CornerTable buildCornerTable(const Triangulation& triangulation, std::size_t vertexCount,
                             const Pulse& pulse = {});

/// The half-edge that leaves the same vertex next in clockwise order; kNone when the boundary is in
/// between.
inline std::uint32_t rotateClockwise(const std::vector<std::uint32_t>& twin, std::uint32_t h) {
  return twin[h] == kNone ? kNone : nextCorner(twin[h]);
}
/// The same in counter-clockwise order.
inline std::uint32_t rotateCounterClockwise(const std::vector<std::uint32_t>& twin,
                                            std::uint32_t h) {
  return twin[prevCorner(h)];
}

}  // namespace abflat
