#pragma once

#include "abflat/inspect.h"
#include "mesh/corner_table.h"
#include "mesh/topology.h"
#include "mesh/triangulate.h"

namespace abflat {

/// A mesh with all of its connectivity, and its properties.
struct Surface {
  Triangulation triangulation;
  CornerTable table;
  Fans fans;
  std::vector<SurfaceLoop> boundaryLoops;
  MeshSummary summary;
};

/// Never fails on a mesh that passes validateArrays; summary.disk says whether it can be flattened.
/// The result is unusable if the pulse has stopped. `fine`: see joinStraightPairs.
Surface buildSurface(const PolygonMesh& mesh, const Pulse& pulse = {}, double fine = 0);

/// As without a pulse; the result is unusable if the pulse has stopped.
MeshSummary inspect(const PolygonMesh& mesh, const Pulse& pulse);

}  // namespace abflat
