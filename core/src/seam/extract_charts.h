#pragma once

#include <vector>

#include "cut/cut_surface.h"

namespace abflat {

/// Some charts of a cut surface as a surface of their own, open where it was cut.
struct SeamPart {
  SeamMesh mesh;
  std::vector<std::uint32_t> halfEdge;  ///< of the whole, per half-edge of the part
  std::vector<std::uint32_t> vertex;    ///< of the whole, per vertex of the part
};
SeamPart extractCharts(const SeamMesh& mesh, const CutSurface& surface,
                       const std::vector<std::uint8_t>& isWanted, const Pulse& pulse = {});

}  // namespace abflat
