#pragma once

#include <vector>

#include "cut/surface_mesh.h"

namespace abflat {

/// A plane that a mesh is symmetric to, but for details and rounding.
struct Mirror {
  IdVector<SurfaceVertex, std::int8_t> side;     ///< 0 on the plane, 1 and -1 beside it
  IdVector<SurfaceCorner, SurfaceCorner> image;  ///< of a half-edge; none where it has none

  explicit operator bool() const { return !side.empty(); }
};

/// False where most of the mesh has no image.
Mirror findMirror(const SeamMesh& mesh, const Pulse& pulse = {});

}  // namespace abflat
