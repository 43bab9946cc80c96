#pragma once

#include <vector>

#include "cut/surface_mesh.h"

namespace abflat {

/// A plane that a mesh is symmetric to, apart from details and rounding.
struct Mirror {
  IdVector<SurfaceVertex, std::int8_t> side;     ///< 0 on the plane, 1 and -1 on its two sides
  IdVector<SurfaceCorner, SurfaceCorner> image;  ///< of each half-edge; none if it has no image

  explicit operator bool() const { return !side.empty(); }
};

/// False if most of the mesh has no image.
Mirror findMirror(const SeamMesh& mesh, const Pulse& pulse = {});

}  // namespace abflat
