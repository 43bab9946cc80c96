#pragma once

#include <vector>

#include "cut/cut_surface.h"

namespace abflat {

/// Half-edges of all edges that join the same two vertices as another edge, in order. Takes time
/// linear in the mesh.
std::vector<SurfaceCorner> doubledEdges(const SeamMesh& mesh);

/// Cuts into pockets: what two edges between the same two vertices of a chart enclose, such as two
/// triangles around one vertex. A flat layout has no room for it, since edges are straight.
/// `doubled`: see doubledEdges.
void openPockets(const SeamMesh& mesh, const std::vector<SurfaceCorner>& doubled, Seams& seams,
                 const Listener& listener = {});

}  // namespace abflat
