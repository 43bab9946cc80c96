#pragma once

#include "abflat/mesh.h"

namespace abflat {

/// Finishes reading normals. `faceNormals` may lack those of the last corners, or refer to normals
/// that do not exist or have no direction: all these corners get none. If no corner has one, the
/// mesh has no normals at all; otherwise smoothing groups do not count.
void settleNormals(PolygonMesh& mesh);

/// The same for normals that are those of vertices, in their order.
void takeVertexNormals(PolygonMesh& mesh);

}  // namespace abflat
