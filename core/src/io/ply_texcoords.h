#pragma once

#include <vector>

#include "abflat/mesh.h"
#include "io/ply_header.h"

namespace abflat {

/// Takes u and v of each corner of the last face. A list of the wrong length counts as no
/// texcoords.
void appendTexcoords(const std::vector<double>& uv, PolygonMesh& mesh);

/// Finishes reading: corners take the texcoords of their vertices, unless they have their own.
void finishTexcoords(const PlyHeader& header, PolygonMesh& mesh);

}  // namespace abflat
