#pragma once

#include <cstdint>
#include <vector>

#include "mesh/corner_table.h"

namespace abflat {

/// Vertices of the surface as its triangles see them: one per fan of triangles that share edges at
/// an input vertex. A vertex where the surface touches itself has several fans. Numbered by input
/// vertex, then by first corner.
struct Fans {
  IdVector<SurfaceCorner, SurfaceVertex> ofCorner;
  IdVector<SurfaceVertex, InputVertex> inputVertex;
};
Fans findFans(const CornerTable& table, std::size_t vertexCount);

/// Connected components of a surface.
using ComponentId = Id<struct ComponentTag>;
struct Components {
  IdVector<SurfaceTriangle, ComponentId> ofTriangle;
  IdVector<ComponentId, SurfaceTriangle> firstTriangle;
};
Components findComponents(const CornerTable& table);

/// Half-edges of one boundary loop, in order, with the surface on their left.
using SurfaceLoop = std::vector<SurfaceCorner>;
std::vector<SurfaceLoop> findBoundaryLoops(const CornerTable& table);

}  // namespace abflat
