#pragma once

#include <vector>

#include "abflat/mesh.h"
#include "mesh/ids.h"

namespace abflat {

/// How far an opened corner moves, relative to the shorter of its edges: far enough for what it
/// opens to survive the precision of files, near enough not to be seen.
constexpr double kOpening = 0x1p-10;

/// Gives corners at which a face touches itself a vertex of their own, a little to the right of the
/// way around the face, where it has no area. Faces that lie there share the new vertex.
void openCorners(const std::vector<PolygonCorner>& corners, PolygonMesh& mesh);

}  // namespace abflat
