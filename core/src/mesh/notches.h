#pragma once

#include "mesh/surface.h"
#include "mesh/welded_mesh.h"

namespace abflat {

/// The two outer ends of each slit in a boundary that is one edge long, has no width and ends where
/// the surface is nearly flat, so that it relieves no stretch. Spheres whose faces each have their
/// own pole have one between any two of these faces. None if closing them all would leave no
/// boundary.
VertexPairs findNotches(const PolygonMesh& mesh, const Surface& surface);

}  // namespace abflat
