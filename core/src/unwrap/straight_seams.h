#pragma once

#include <vector>

#include "boundary/straight_runs.h"
#include "unwrap/cut_mesh.h"

namespace abflat {

/// Straight parts of one chart's boundary.
struct StraightSeams {
  StraightPlaces places;     ///< boundary places where the layout goes straight on
  std::size_t released = 0;  ///< places between the ends of seams that are not straight
};

/// For each half-edge of a surface, the next one on the same chart's boundary; none inside charts.
using Outlines = IdVector<SurfaceCorner, SurfaceCorner>;

/// `isCut`: for each half-edge, whether a chart ends there. Rims of holes are outlines as well.
Outlines findOutlines(const Surface& surface, const IdVector<SurfaceCorner, std::uint8_t>& isCut);
Outlines findOutlines(const Surface& surface, const ChartSet& set);

/// Whether seams end at the same places of a chart for two outlines that are equal along its own
/// boundary.
bool hasSameEnds(const CutMesh& mesh, ChartId chart, const Outlines& a, const Outlines& b);

/// Straightens seams and boundaries from end to end, per chart. Ends are junctions, where the chart
/// on the other side changes, tips, and corners of the surface. A run that turns a lot on the
/// surface stays as it is, such as the rim of a round lid; so does one that no layout could make
/// straight. `isFixed` (per triangle of the surface, or empty) excludes given islands, which need
/// not be disks.
IdVector<ChartId, StraightSeams> straightSeams(
    const Surface& surface, const ChartSet& set, const Outlines& outlines,
    const IdVector<SurfaceTriangle, std::uint8_t>& isFixed);

}  // namespace abflat
