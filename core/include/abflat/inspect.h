#pragma once

#include <cstdint>
#include <string>

#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat {

/// What a mesh is, topologically. Counts only; `disk` is Ok when `flatten` accepts the mesh and
/// otherwise says what stands in the way, with counts and the first place.
struct MeshSummary {
  std::size_t vertices = 0;
  std::size_t unreferencedVertices = 0;
  std::size_t faces = 0;
  std::size_t triangles = 0;   ///< after triangulating polygons
  std::size_t components = 0;  ///< edge-connected
  std::size_t boundaryLoops = 0;
  std::size_t boundaryEdges = 0;
  std::size_t nonManifoldEdges = 0;      ///< edges with more than two faces
  std::size_t orientationConflicts = 0;  ///< edges whose two faces run in the same direction
  std::size_t degenerateFaces = 0;       ///< zero area or collinear corners
  std::int64_t eulerCharacteristic = 0;
  std::int64_t genus =
      0;  ///< summed over components; -1 when not defined (non-manifold or not orientable as given)
  std::size_t texcoords = 0;  ///< that the file has
  std::size_t materials = 0;  ///< that faces have
  Status disk;
};

MeshSummary inspect(const PolygonMesh& mesh);

/// JSON object with the fields of MeshSummary, plus "disk": {"ok", "code", "message"}.
std::string inspectJson(const MeshSummary& summary, const std::string& path);

}  // namespace abflat
