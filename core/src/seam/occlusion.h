#pragma once

#include <vector>

#include "cut/surface_mesh.h"

namespace abflat {

/// How much of the view from a triangle is blocked by the surface itself: 0 on a convex body, near
/// 1 at the bottom of a groove, between legs, behind an ear. Accurate to some hundred patches.
IdVector<SurfaceTriangle, double> occlusion(const SeamMesh& mesh, const Listener& listener = {});

}  // namespace abflat
