#pragma once

#include "cut/surface_mesh.h"

namespace abflat {

/// How many variants of costs there are.
constexpr int kCostVariants = 6;

/// Makes seams a little dearer or cheaper where the surface faces along one of its principal axes,
/// so that a search takes other ways to seams that are about as good. What is symmetric stays so.
/// `variant`: from 1 to kCostVariants; 0 changes nothing.
void varyCosts(int variant, SeamMesh& mesh);

}  // namespace abflat
