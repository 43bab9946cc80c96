#pragma once

#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "base/pulse.h"

namespace abflat {

/// Triangles of a polygon mesh, for solving only. A face of n corners gives n - 2 triangles that
/// together have every edge of the face exactly once, whatever its shape.
struct Triangulation {
  std::vector<std::uint32_t> vertex;     ///< input vertex per triangle corner, size 3T
  std::vector<std::uint32_t> corner;     ///< input face corner (index into faceVertices), size 3T
  std::vector<std::uint32_t> face;       ///< input face per triangle, size T
  std::vector<std::uint8_t> isDiagonal;  ///< half-edge is a diagonal of its face, size 3T
};

/// Convex quads are cut from their first corner to the third, others by ear clipping in the plane
/// of each face's area vector; concave faces keep their shape.
Triangulation triangulate(const PolygonMesh& mesh, const Pulse& pulse = {});

}  // namespace abflat
