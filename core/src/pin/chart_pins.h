#pragma once

#include <vector>

#include "abflat/mesh.h"
#include "abflat/pins.h"
#include "abflat/status.h"
#include "chart/ids.h"
#include "mesh/ids.h"
#include "pin/pinned_layout.h"

namespace abflat {

/// The texcoords of an input's corners, numbered through all charts.
struct Texcoords {
  IdVector<InputCorner, TexcoordId> ofCorner;  ///< none where the corner has none
  IdVector<ChartId, TexcoordId> firstOf;       ///< of each chart; ends with their count
};

/// The pins of each chart, at their uv. Errors: InvalidOption for a pin that does not tell a
/// texcoord and a place, for two that contradict each other, and for one that is alone in its
/// chart.
Result<IdVector<ChartId, std::vector<ChartPin>>> pinsOfCharts(const PolygonMesh& mesh,
                                                              const Texcoords& texcoords,
                                                              const std::vector<Pin>& pins);

}  // namespace abflat
