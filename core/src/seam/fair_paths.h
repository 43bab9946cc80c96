#pragma once

#include <cstdint>
#include <vector>

#include "base/pulse.h"
#include "cut/cut_surface.h"

namespace abflat {

/// Of a path along half-edges that follow each other: the cost of its edges, and where it turns a
/// share of those beside that grows with the square of the angle, as it is on the surface.
double pathCost(const SeamMesh& mesh, const IdVector<SurfaceCorner, double>& cost,
                const std::vector<SurfaceCorner>& path);

/// Of an edge's length, what it costs at least.
constexpr double kLeastCost = 0.3;

/// Draws each seam between ends and junctions anew, as a path of less cost near where it was. The
/// junction that it comes from may slide along other seams. Charts stay as many, and keep their
/// topology. `cost` is that of a seam along a half-edge, and `width` says of one that is there how
/// far away its path may go, over its length; 0: the edge stays. False when nothing is changed.
bool fairPaths(const SeamMesh& mesh, const IdVector<SurfaceCorner, double>& cost,
               IdVector<SurfaceCorner, float> width, Seams& seams, const Pulse& pulse = {});

}  // namespace abflat
