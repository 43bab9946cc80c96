#pragma once

#include "mesh/surface.h"
#include "mesh/welded_mesh.h"

namespace abflat {

/// The two outer ends of each slit in a boundary that is one edge long, has no width and ends where
/// the surface is nearly flat, so that it spares no stretch. Poles of spheres have one between any
/// two faces, where each face has a pole of its own. None where closing them all would leave no
/// boundary.
VertexPairs findNotches(const PolygonMesh& mesh, const Surface& surface);

}  // namespace abflat
