#pragma once

#include <vector>

#include "abflat/mesh.h"
#include "io/ply_header.h"

namespace abflat {

/// Takes u and v of each corner of the last face. A list of another length is none.
void appendTexcoords(const std::vector<double>& uv, PolygonMesh& mesh);

/// Ends the reading: texcoords of corners are those of their vertices, unless they have their own.
void finishTexcoords(const PlyHeader& header, PolygonMesh& mesh);

}  // namespace abflat
