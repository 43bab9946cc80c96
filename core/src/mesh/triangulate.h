#pragma once

#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "base/pulse.h"
#include "mesh/ids.h"

namespace abflat {

/// Triangles of a polygon mesh, for solving only. A face of n corners gives n - 2 triangles that
/// together have every edge of the face exactly once, whatever its shape.
struct Triangulation {
  IdVector<SurfaceCorner, InputVertex> vertex;
  IdVector<SurfaceCorner, PolygonCorner> corner;
  IdVector<SurfaceTriangle, PolygonFace> face;
  IdVector<SurfaceCorner, std::uint8_t> isDiagonal;  ///< half-edge is a diagonal of its face
};

/// Convex quads are cut from their first corner to the third, others by ear clipping in the plane
/// of each face's area vector; concave faces keep their shape.
Triangulation triangulate(const PolygonMesh& mesh, const Pulse& pulse = {});

}  // namespace abflat
