#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "base/pulse.h"

namespace abflat {

using VertexPairs = std::vector<std::array<std::uint32_t, 2>>;

/// A mesh as the surface that it shows: vertices at one place are one, faces that use a place twice
/// are split there unless that is how they have holes, and what is left without area is gone. Faces
/// that repeat others become layers of their own, which share no vertex with the first.
struct WeldedMesh {
  PolygonMesh mesh;
  std::vector<std::uint32_t> inputFace;    ///< per face
  std::vector<std::uint32_t> inputCorner;  ///< per face corner: index into the input's faceVertices
  /// Per corner of the input: a corner of `mesh` at the same place, of the same face where that has
  /// one, or kNone where no face is left there.
  std::vector<std::uint32_t> cornerFor;
  std::vector<std::uint32_t> place;           ///< per input vertex: the first one at the same place
  std::size_t mergedVertices = 0;             ///< that are at the place of an earlier one
  std::vector<std::uint32_t> collapsedFaces;  ///< input faces without two different edges
  std::vector<std::uint32_t> splitFaces;      ///< input faces that were split
  /// Input faces that have the places of an earlier one, and that one.
  std::vector<std::array<std::uint32_t, 2>> duplicateFaces;
};

/// `mesh` has passed validateArrays. Without `byPosition` vertices are one only where the mesh says
/// so, or where an edge between them has no length, or if they are `joined`. What comes of a pulse
/// that has stopped is of no use.
WeldedMesh weld(const PolygonMesh& mesh, bool byPosition = true, const Pulse& pulse = {},
                const VertexPairs& joined = {});

}  // namespace abflat
