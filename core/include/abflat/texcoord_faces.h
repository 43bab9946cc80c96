#pragma once

#include <cstdint>
#include <vector>

#include "abflat/export.h"
#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat {

/// Faces that have texcoords at all of their corners, ascending. Passed as
/// ReuseOptions::fixedFaces, they keep these texcoords. Errors: InvalidOption when the mesh has no
/// texcoords.
ABFLAT_API Result<std::vector<std::uint32_t>> facesWithTexcoords(const PolygonMesh& mesh);

}  // namespace abflat
