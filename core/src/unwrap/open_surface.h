#pragma once

#include "chart/chart_set.h"
#include "mesh/welded_mesh.h"
#include "seam/find_seams.h"

namespace abflat {

/// The surface, its holes filled, with the seams that cut it to disks.
struct OpenSurface {
  SeamMesh mesh;
  double unit = 1;                                   ///< of `mesh`, in units of the input
  IdVector<SurfaceVertex, InputVertex> inputVertex;  ///< a vertex of the welded mesh
  Seams given;                                       ///< seams of the surface
  Seams seams;  ///< seams of `mesh`; given ones may be on its boundary instead
  Seams found;  ///< seams before they were shortened; a superset of `seams`
  EliminationRanks eliminationRanks;  ///< of `mesh`
  LogScales scale;                    ///< expected
  LogScales foundScale;               ///< expected, before seams were shortened
  Mirror mirror;                      ///< what the seams are symmetric to, if they are
  Asymmetry asymmetry = Asymmetry::None;
  Seams plates;          ///< the borders of flat regions that were cut out, see plateBorders
  int variant = 0;       ///< of the costs, where charts are cut further
  KnownSeams otherwise;  ///< to be used if symmetric seams are worse than expected

  bool isGiven(SurfaceCorner h) const { return h < given.size() && given[h]; }
};

/// Per vertex of the mesh the least rank of its fans, or the last of all.
IdVector<InputVertex, std::uint32_t> ranksOfMesh(const OpenSurface& open, std::size_t vertices);

ChartSet chartsOf(const WeldedMesh& welded, const OpenSurface& open);

}  // namespace abflat
