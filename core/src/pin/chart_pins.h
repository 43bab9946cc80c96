#pragma once

#include <vector>

#include "abflat/mesh.h"
#include "abflat/pins.h"
#include "abflat/status.h"
#include "pin/pinned_layout.h"

namespace abflat {

/// The texcoords of an input's corners, numbered through all charts: those of chart i begin at
/// firstOf[i], which ends with their count.
struct Texcoords {
  std::vector<std::uint32_t> ofCorner;  ///< kNone where the corner has none
  std::vector<std::uint32_t> firstOf;
};

/// The pins of each chart, at their uv. Errors: InvalidOption for a pin that does not tell a
/// texcoord and a place, for two that contradict each other, and for one that is alone in its
/// chart.
Result<std::vector<std::vector<ChartPin>>> pinsOfCharts(const PolygonMesh& mesh,
                                                        const Texcoords& texcoords,
                                                        const std::vector<Pin>& pins);

}  // namespace abflat
