#pragma once

#include "cut/cut_surface.h"

namespace abflat {

/// The cuts required by the topology.
struct TopologyCut {
  std::uint32_t handleLoops = 0;  ///< two for each handle
  std::uint32_t joinedLoops = 0;  ///< boundary loops joined to others
  std::uint32_t openedSpheres = 0;
  double length = 0;  ///< of all these seams, in the mesh's unit
};

/// Adds the seams that make every chart a topological disk. `anchors`: the vertex of each chart
/// from which it is opened if it is closed; empty: any vertex.
TopologyCut cutToDisks(const SeamMesh& mesh, const CutSurface& surface,
                       const IdVector<CutChartId, OpenVertex>& anchors, Seams& seams,
                       const Listener& listener = {});

}  // namespace abflat
