#pragma once

#include "cut/surface_mesh.h"

namespace abflat {

/// How far each edge is in the front of its component, from 0 to 1: where people look, as at a
/// face. The front faces the level direction in which most hollows open, such as eye sockets, the
/// sides of a nose and a mouth. Empty if no component has a front.
/// `bend`: see edgeBends; `upAxis`: the coordinate that points up.
IdVector<SurfaceCorner, double> findFront(const SeamMesh& mesh,
                                          const IdVector<SurfaceCorner, double>& bend,
                                          std::size_t upAxis);

/// How far each triangle is in the front, from 0 to 1, by what seams cost there. Empty: not at all.
IdVector<SurfaceTriangle, double> trianglesInFront(const SeamMesh& mesh);

/// Share of the surface where seams are dearer because it is in a front.
double shareInFront(const SeamMesh& mesh);

}  // namespace abflat
