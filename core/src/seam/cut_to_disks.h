#pragma once

#include "cut/cut_surface.h"

namespace abflat {

/// What topology needed.
struct TopologyCut {
  std::uint32_t handleLoops = 0;  ///< two for each handle
  std::uint32_t joinedLoops = 0;  ///< boundary loops joined to others
  std::uint32_t openedSpheres = 0;
  double length = 0;  ///< of all these seams, in the mesh's unit
};

/// Adds the seams that make every chart a topological disk. `anchors`, where not empty, has for
/// each chart of `surface` the vertex (of the cut surface) from which a closed one is opened.
TopologyCut cutToDisks(const SeamMesh& mesh, const CutSurface& surface,
                       std::vector<std::uint32_t> anchors, Seams& seams, const Pulse& pulse = {});

}  // namespace abflat
