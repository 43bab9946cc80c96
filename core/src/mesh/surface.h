#pragma once

#include <functional>

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
/// The result is unusable if the listener has stopped. `fineOf`: tells the length for
/// joinStraightPairs; if empty, it is 0.
using FineLength = std::function<double(const CornerTable&)>;
Surface buildSurface(const PolygonMesh& mesh, const Listener& listener = {},
                     const FineLength& fineOf = {});

/// As without a listener; the result is unusable if the listener has stopped.
MeshSummary inspect(const PolygonMesh& mesh, const Listener& listener);

}  // namespace abflat
