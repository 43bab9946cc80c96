#pragma once

#include "layout/convex_combination.h"

namespace abflat {

// Weights of the reference methods for embedByWeights. Triangles of zero area get made-up angles,
// so that every weight is finite.

/// Floater, "Mean value coordinates", 2003: at vertex i towards j, (tan(a/2) + tan(b/2)) / |ij|
/// with the angles a and b at i beside the edge. Positive, so the embedding in a convex outline is
/// valid.
HalfEdgeWeights meanValueWeights(const DiskChart& chart);

/// Pinkall and Polthier 1993, Eck et al. 1995: (cot a + cot b)/2 with the angles a and b opposite
/// the edge. The result minimises the Dirichlet energy; with a fixed boundary this is the same as
/// Desbrun et al.'s discrete conformal parameterization (2002). Weights of obtuse pairs are
/// negative, so triangles may flip.
HalfEdgeWeights harmonicWeights(const DiskChart& chart);

}  // namespace abflat
