#pragma once

#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "base/listener.h"
#include "mesh/ids.h"

namespace abflat {

/// Triangles of a polygon mesh, for solving only. A face with n corners gives n - 2 triangles that
/// together have every edge of the face exactly once, whatever its shape.
struct Triangulation {
  IdVector<SurfaceCorner, InputVertex> vertex;
  IdVector<SurfaceCorner, PolygonCorner> corner;
  IdVector<SurfaceTriangle, PolygonFace> face;
  IdVector<SurfaceCorner, std::uint8_t> isDiagonal;  ///< half-edge is a diagonal of its face
};

/// Convex quads are split from their first corner to the third; other faces by ear clipping in the
/// plane of their area vector, so that concave faces keep their shape.
Triangulation triangulate(const PolygonMesh& mesh, const Listener& listener = {});

}  // namespace abflat
