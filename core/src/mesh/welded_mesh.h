#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "base/pulse.h"
#include "mesh/ids.h"

namespace abflat {

using VertexPairs = std::vector<std::array<std::uint32_t, 2>>;

/// A mesh as the surface that it shows: vertices at one place are one, faces that use a place twice
/// are split there unless that is how they have holes, and what is left without area is gone. Faces
/// that repeat others become layers of their own, which share no vertex with the first.
struct WeldedMesh {
  PolygonMesh mesh;
  IdVector<PolygonFace, InputFace> inputFace;
  IdVector<PolygonCorner, InputCorner> inputCorner;
  /// A corner of `mesh` at the same place, of the same face where that has one; none where no face
  /// is left there.
  IdVector<InputCorner, PolygonCorner> cornerFor;
  IdVector<InputVertex, InputVertex> firstAtPlace;  ///< the first vertex at the same place
  std::size_t mergedVertices = 0;                   ///< that are at the place of an earlier one
  std::vector<std::uint32_t> collapsedFaces;        ///< input faces without two different edges
  std::vector<std::uint32_t> splitFaces;            ///< input faces that were split
  /// Input faces that have the places of an earlier one, and that one.
  std::vector<std::array<std::uint32_t, 2>> duplicateFaces;
};

/// `mesh` has passed validateArrays. Without `byPosition` vertices are one only where the mesh says
/// so, or where an edge between them has no length, or if they are `joined`. What comes of a pulse
/// that has stopped is of no use.
WeldedMesh weld(const PolygonMesh& mesh, bool byPosition = true, const Pulse& pulse = {},
                const VertexPairs& joined = {});

}  // namespace abflat
