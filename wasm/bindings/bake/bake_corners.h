#pragma once

#include <vector>

#include "abflat/status.h"
#include "bake/bake_job.h"

namespace abflat::bindings {

/// Checks that the triangles of the layout are those of the mesh, with corners in the same order or
/// with the last two swapped; `isTurned` tells, per triangle. Errors: InvalidMesh.
Status matchCorners(const BakeJob& job, std::vector<bool>& isTurned);

/// The triangles without normals and tangents, once corners match.
BakeTriangles trianglesOf(const BakeJob& job);

/// Adds what a normal map needs. Errors: InvalidMesh, for a number that is not finite.
Status addFrames(const BakeJob& job, const std::vector<bool>& isTurned, BakeTriangles& out);

}  // namespace abflat::bindings
