#pragma once

#include <vector>

#include "abflat/pins.h"
#include "abflat/status.h"
#include "chart/ids.h"
#include "mesh/ids.h"
#include "mesh/input_mesh.h"
#include "pin/pinned_layout.h"

namespace abflat {

/// The texcoords of an input's corners, numbered across all charts.
struct Texcoords {
  IdVector<InputCorner, TexcoordId> ofCorner;  ///< none if the corner has no texcoord
  IdVector<ChartId, TexcoordId> firstOf;       ///< of each chart; ends with the total
};

/// The pins of each chart, at their uv. Errors: InvalidOption for a pin that does not determine a
/// texcoord and a place, for two pins that contradict each other, and for a single pin in a chart.
Result<IdVector<ChartId, std::vector<ChartPin>>> pinsOfCharts(const InputMesh& mesh,
                                                              const Texcoords& texcoords,
                                                              const std::vector<Pin>& pins);

}  // namespace abflat
