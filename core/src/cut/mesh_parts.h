#pragma once

#include "cut/surface_mesh.h"
#include "mesh/triangle_geometry.h"

namespace abflat {

/// The unit normal of each triangle, zero if it has no area.
IdVector<SurfaceTriangle, Vec3> triangleNormals(const SeamMesh& mesh);

/// For each triangle the least one of its component.
IdVector<SurfaceTriangle, SurfaceTriangle> componentsOf(const SeamMesh& mesh);

}  // namespace abflat
