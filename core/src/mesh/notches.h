#pragma once

#include "mesh/surface.h"
#include "mesh/welded_mesh.h"

namespace abflat {

/// The two outer ends of each slit in a boundary that is one edge long and has no width. Poles of
/// spheres and tips of cones have one between any two faces, where each face has a pole of its own.
/// None where closing them all would leave no boundary.
VertexPairs findNotches(const PolygonMesh& mesh, const Surface& surface);

}  // namespace abflat
