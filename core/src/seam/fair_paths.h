#pragma once

#include <cstdint>
#include <vector>

#include "base/listener.h"
#include "cut/cut_surface.h"

namespace abflat {

/// Cost of a path of consecutive half-edges: the cost of its edges plus, at each turn, a share of
/// the lengths of the two edges that grows with the square of the turning angle on the surface.
double pathCost(const SeamMesh& mesh, const IdVector<SurfaceCorner, double>& cost,
                const std::vector<SurfaceCorner>& path);

/// The least cost of an edge, relative to its length.
constexpr double kLeastCost = 0.05;

/// Redraws each seam between ends and junctions as a cheaper path near its former place. The
/// junction that a path comes from may slide along other seams. The number of charts and their
/// topology stay the same. `cost` is that of a seam along a half-edge. `width` says, for each
/// half-edge of a seam, how far its path may move, divided by the path's length; 0: the edge stays.
/// False if nothing has changed.
bool fairPaths(const SeamMesh& mesh, const IdVector<SurfaceCorner, double>& cost,
               IdVector<SurfaceCorner, float> width, Seams& seams, const Listener& listener = {});

}  // namespace abflat
