#pragma once

#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "base/pulse.h"

namespace abflat {

/// Vertices at one place, so that split normals, triangle soups and STL are the surfaces they show.
struct Welding {
  std::vector<std::uint32_t> ofVertex;  ///< first vertex at the same place, per vertex
  std::size_t merged = 0;               ///< vertices that are at the place of an earlier one
  double reach = 0;                     ///< how far apart places may be
  bool isExact = true;                  ///< all that were merged have the same coordinates
};

/// Relative to the diagonal of the bounding box: above the rounding of float32, below most edges.
constexpr double kWeldTolerance = 1e-7;

/// Vertices no further apart than the tolerance times the diagonal of the bounding box. A vertex
/// joins the first one that stands for others, so places never grow beyond the tolerance. Linear in
/// the vertices, wherever they are. `positions` are xyz and finite.
Welding weldVertices(const std::vector<double>& positions, double tolerance = kWeldTolerance,
                     const Pulse& pulse = {});

/// Those of the same coordinates.
Welding weldEqualVertices(const std::vector<double>& positions, const Pulse& pulse = {});

/// Those of the same coordinates, and others within the tolerance where the surface would be open
/// between them; no two different places of one face, so detail below the tolerance stays. Vertices
/// that no face uses are left out: they stay apart, and the bounding box is that of the others.
Welding weldSurface(const PolygonMesh& mesh, const Pulse& pulse = {});

}  // namespace abflat
