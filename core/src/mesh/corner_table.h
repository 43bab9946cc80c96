#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/ids.h"
#include "mesh/triangulate.h"

namespace abflat {

/// An edge that keeps the mesh from being an oriented manifold, with its first two or three faces.
struct BadEdge {
  InputVertex v0, v1;
  std::uint32_t faceCount = 0;
  std::uint32_t pairs = 0;  ///< of its faces that are joined
  std::array<PolygonFace, 2> faces;
};

/// Connectivity of a triangulation. Bad edges have no twins, so the surface is cut open along them,
/// unless some of their faces are joined.
struct CornerTable {
  IdVector<SurfaceCorner, InputVertex> vertex;
  IdVector<SurfaceCorner, SurfaceCorner> twin;  ///< opposite half-edge, none on the boundary
  std::vector<BadEdge> nonManifold;             ///< more than two faces
  std::vector<SurfaceCorner>
      nonManifoldCorners;            ///< half-edges of each of these, one after another
  std::vector<BadEdge> misoriented;  ///< two faces that traverse it in the same direction

  IdRange<SurfaceTriangle> triangles() const { return IdRange<SurfaceTriangle>(vertex.size() / 3); }
  IdRange<SurfaceCorner> corners() const { return vertex.ids(); }
};

/// Polygon edges are matched by their two vertices, diagonals only within their own face, so a
/// diagonal never becomes a non-manifold edge. Linear in the mesh apart from sorting within one
/// vertex.
CornerTable buildCornerTable(const Triangulation& triangulation, std::size_t vertexCount,
                             const Listener& listener = {});

}  // namespace abflat
