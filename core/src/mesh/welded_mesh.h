#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "base/listener.h"
#include "mesh/ids.h"
#include "mesh/weld_edges.h"

namespace abflat {

/// A mesh as the surface that it shows. Vertices at one place are merged, and parts without area
/// are dropped. A face stays one polygon, however often it touches itself: where pieces of its
/// inside meet, or a bridge leads from one to another, its corners get vertices of their own, moved
/// so that the pieces hang together. Faces that repeat others become layers of their own, which
/// share no vertex with the first.
struct WeldedMesh {
  PolygonMesh mesh;
  IdVector<PolygonFace, InputFace> inputFace;
  IdVector<PolygonCorner, InputCorner> inputCorner;
  /// The corner itself, or the one that stands for it at the same place of its face; none if it
  /// bounds nothing.
  IdVector<InputCorner, PolygonCorner> cornerFor;
  IdVector<InputVertex, InputVertex> firstAtPlace;  ///< the first vertex at the same place
  std::size_t mergedVertices = 0;                   ///< those at the place of an earlier one
  std::vector<std::uint32_t> collapsedFaces;        ///< input faces without two different edges
  std::vector<std::uint32_t> splitFaces;            ///< input faces that touch themselves
  /// Input faces at the same places as an earlier one, with that earlier one.
  std::vector<std::array<std::uint32_t, 2>> duplicateFaces;
};

/// `mesh` must have passed validateArrays. Without `byPosition`, vertices are merged only if the
/// mesh says so, if the edge between them is too short to be seen, or if they are `joined`. The
/// result is unusable if the listener has stopped.
WeldedMesh weld(const PolygonMesh& mesh, bool byPosition = true, const Listener& listener = {},
                const VertexPairs& joined = {});

}  // namespace abflat
