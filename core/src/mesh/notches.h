#pragma once

#include "mesh/surface.h"
#include "mesh/welded_mesh.h"

namespace abflat {

/// The two outer ends of each slit in a boundary that is one edge long, has no width and ends where
/// the surface is nearly flat, so that it relieves no stretch. At the pole of a sphere there is one
/// between any two faces if each face has its own pole vertex. None if closing them all would leave
/// no boundary.
VertexPairs findNotches(const PolygonMesh& mesh, const Surface& surface);

}  // namespace abflat
