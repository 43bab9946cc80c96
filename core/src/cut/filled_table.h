#pragma once

#include "cut/cut_surface.h"
#include "mesh/corner_table.h"

namespace abflat {

/// A surface that has been cut, followed by the fillings of the holes that stay filled.
struct FilledTable {
  CornerTable table;  ///< no twins across seams
  std::size_t surfaceTriangles = 0;
  std::vector<HoleId> hole;  ///< the hole that each triangle after those fills
};

/// A hole stays filled if no edge of its filling is a seam. `vertices`: the input vertex of each
/// vertex of `mesh`.
FilledTable filledTable(const SeamMesh& mesh, const IdVector<SurfaceVertex, InputVertex>& vertices,
                        const Seams& seams);

}  // namespace abflat
