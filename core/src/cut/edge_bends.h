#pragma once

#include "cut/surface_mesh.h"

namespace abflat {

/// How far the surface turns across each edge, in radians. It is measured between the directions on
/// either side, at right angles to the edge and within a small share of the size of its component.
/// So a narrow face of a bevel bends as much as the crease that it stands for, and noise does not.
/// Negative where the surface is hollow; 0 on the boundary.
IdVector<SurfaceCorner, double> edgeBends(const SeamMesh& mesh, const Listener& listener = {});

}  // namespace abflat
