#pragma once

#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "base/listener.h"

namespace abflat {

/// Vertices merged by position, so that split normals, triangle soups and STL become the surfaces
/// they show.
struct Welding {
  std::vector<std::uint32_t> ofVertex;  ///< first vertex at the same place, per vertex
  std::size_t merged = 0;               ///< vertices at the place of an earlier one
  double reach = 0;                     ///< largest distance between merged vertices
  bool isExact = true;                  ///< all merged vertices have identical coordinates
};

/// Relative to the diagonal of the bounding box: above the rounding of float32, below most edges.
constexpr double kWeldTolerance = 1e-7;

/// Merges vertices no further apart than the tolerance times the diagonal of the bounding box. A
/// vertex joins the first one that represents others, so places never grow beyond the tolerance.
/// Linear in the number of vertices, wherever they are. `positions` are xyz and finite.
Welding weldVertices(const std::vector<double>& positions, double tolerance = kWeldTolerance,
                     const Listener& listener = {});

/// Merges vertices with identical coordinates.
Welding weldEqualVertices(const std::vector<double>& positions, const Listener& listener = {});

/// Merges vertices with identical coordinates, and others within the tolerance if the surface would
/// be open between them, if they are of one object. Never merges two different places of one face,
/// so detail below the tolerance stays. Vertices that no face uses stay separate and do not affect
/// the bounding box.
Welding weldSurface(const PolygonMesh& mesh, const Listener& listener = {});

}  // namespace abflat
