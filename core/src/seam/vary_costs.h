#pragma once

#include "cut/surface_mesh.h"

namespace abflat {

/// How many variants of costs there are, and how many more where the surface has a front.
constexpr int kCostVariants = 6, kFrontVariants = 2;

/// Makes seams a little dearer or cheaper where the surface faces along one of its principal axes,
/// so that a search takes other ways to seams that are about as good. What is symmetric stays so.
/// `variant`: from 1 to kCostVariants; 0 changes nothing. Beyond kCostVariants, or in triangles in
/// the front, seams in the front are several times as dear as they are anyway, or so dear that they
/// are made only if nothing else will do, in turn.
void varyCosts(int variant, SeamMesh& mesh);

inline bool isForFront(int variant) { return variant > kCostVariants; }

}  // namespace abflat
