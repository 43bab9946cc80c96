#pragma once

#include "abflat/mesh.h"

namespace abflat {

/// Finishes reading texcoords. `faceTexcoords` may lack those of the last corners, or refer to
/// texcoords that do not exist or are not finite: all these corners get none. If no corner has one,
/// the mesh has no texcoords at all.
void settleTexcoords(PolygonMesh& mesh);

}  // namespace abflat
