#pragma once

#include "abflat/inspect.h"
#include "mesh/corner_table.h"
#include "mesh/topology.h"
#include "mesh/triangulate.h"

namespace abflat {

/// A mesh with all of its connectivity, and what it is.
struct Surface {
  Triangulation triangulation;
  CornerTable table;
  Fans fans;
  std::vector<std::vector<std::uint32_t>> boundaryLoops;
  MeshSummary summary;
};

/// Never fails on a mesh that passes validateArrays; summary.disk says whether it can be flattened.
Surface buildSurface(const PolygonMesh& mesh);

}  // namespace abflat
