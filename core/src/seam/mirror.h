#pragma once

#include <vector>

#include "cut/surface_mesh.h"

namespace abflat {

/// A plane that a mesh is symmetric to, but for details and rounding.
struct Mirror {
  std::vector<std::int8_t> side;        ///< per vertex: 0 on the plane, 1 and -1 beside it
  std::vector<std::uint32_t> halfEdge;  ///< per half-edge, its image or kNone

  explicit operator bool() const { return !side.empty(); }
};

/// False where most of the mesh has no image.
Mirror findMirror(const SeamMesh& mesh, const Pulse& pulse = {});

}  // namespace abflat
