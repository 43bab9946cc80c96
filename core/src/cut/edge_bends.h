#pragma once

#include "base/constants.h"
#include "cut/surface_mesh.h"

namespace abflat {

/// In radians. Below the first the surface is flat, below the second it is smooth.
constexpr double kFlatBend = 1e-3, kSmoothBend = 10 * kPi / 180;

/// How far the surface turns across each edge, in radians. It is measured between the directions on
/// either side, at right angles to the edge and within a small share of the size of its component.
/// So a narrow face of a bevel bends as much as the crease that it stands for, and noise does not.
/// Negative where the surface is hollow; 0 on the boundary. Where it is flat or smooth at any
/// width, only the angle between two triangles is measured, which takes less time.
IdVector<SurfaceCorner, double> edgeBends(const SeamMesh& mesh, const Listener& listener = {});

}  // namespace abflat
