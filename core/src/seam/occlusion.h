#pragma once

#include <vector>

#include "cut/surface_mesh.h"

namespace abflat {

/// Per triangle, how much of what it looks out on is the surface itself: 0 on a convex body, near 1
/// at the bottom of a groove, between legs, behind an ear. To the accuracy of some hundred patches.
std::vector<double> occlusion(const SeamMesh& mesh, const Pulse& pulse = {});

}  // namespace abflat
