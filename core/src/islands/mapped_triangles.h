#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "islands/find_islands.h"
#include "islands/island_triangles.h"
#include "mesh/triangulate.h"

namespace abflat {

/// The triangles of a mesh that belong to islands, island by island.
struct MappedTriangles {
  IslandTriangles inUv;
  std::vector<std::array<std::uint32_t, 3>> corners;  ///< per triangle, of the mesh
  std::vector<std::uint32_t> face;                    ///< per triangle
  std::vector<std::uint32_t> ofMesh;                  ///< per triangle, its number in the mesh
};

MappedTriangles mappedTriangles(const PolygonMesh& mesh, const Islands& islands,
                                const Triangulation& all);

/// Per island, its area in 3D. Positions are divided by 2^exponent first.
std::vector<double> surfaceAreas(const PolygonMesh& mesh, const MappedTriangles& triangles,
                                 int exponent);

}  // namespace abflat
