#pragma once

#include "abflat/mesh.h"

namespace abflat {

/// Ends the reading of texcoords. `faceTexcoords` may lack those of the last corners, refer to
/// texcoords that do not exist, or to some that are not finite: all these corners have none. Where
/// no corner has one, the mesh has no texcoords at all.
void settleTexcoords(PolygonMesh& mesh);

}  // namespace abflat
