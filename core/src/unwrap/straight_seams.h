#pragma once

#include <vector>

#include "boundary/straight_runs.h"
#include "unwrap/cut_mesh.h"

namespace abflat {

/// Of one chart.
struct StraightSeams {
  StraightPlaces places;     ///< of the boundary, where the layout goes straight on
  std::size_t released = 0;  ///< places between ends of seams that are not
};

/// Per half-edge of a surface the next one of the same chart's boundary; none inside of charts.
using Outlines = IdVector<SurfaceCorner, SurfaceCorner>;

/// `isCut`: of each half-edge, whether a chart ends there. Rims of holes are outlines as well.
Outlines findOutlines(const Surface& surface, const IdVector<SurfaceCorner, std::uint8_t>& isCut);
Outlines findOutlines(const Surface& surface, const ChartSet& set);

/// Whether seams have their ends at the same places of a chart for two outlines that are equal
/// along its own boundary.
bool hasSameEnds(const CutMesh& mesh, ChartId chart, const Outlines& a, const Outlines& b);

/// Seams and boundaries from end to end, per chart. Ends are junctions, where the chart on the
/// other side changes, tips, and corners of the surface. A run that turns much on the surface stays
/// as it is, like the rim of a round lid; so does what no layout could have straight. Nothing is
/// straightened where `isFixed` says so, per triangle of the surface unless empty: islands that are
/// given need not be disks.
IdVector<ChartId, StraightSeams> straightSeams(
    const Surface& surface, const ChartSet& set, const Outlines& outlines,
    const IdVector<SurfaceTriangle, std::uint8_t>& isFixed);

}  // namespace abflat
