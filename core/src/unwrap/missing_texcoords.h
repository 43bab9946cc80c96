#pragma once

#include "mesh/surface_map.h"
#include "pin/chart_pins.h"

namespace abflat {

/// Gives corners that bound nothing texcoords in the chart of their face, each where the chart has
/// the corner's place next to the neighbour's, otherwise at the neighbour's. A face without area
/// takes those of a face beside it. None is left where neither is beside a chart.
void fillMissing(const SurfaceMap& map, const IdVector<SurfaceCorner, TexcoordId>& ofSurface,
                 IdVector<InputCorner, TexcoordId>& ofCorner);

}  // namespace abflat
