#pragma once

#include "abflat/mesh.h"
#include "islands/mapped_triangles.h"

namespace abflat {

/// The aspect of the texture that a layout was made for: `aspect`, or 1 if angles on the surface
/// say that it was a square.
double oldAspect(const PolygonMesh& mesh, const MappedTriangles& triangles, double aspect);

}  // namespace abflat
