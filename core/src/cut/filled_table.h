#pragma once

#include "cut/cut_surface.h"
#include "mesh/corner_table.h"

namespace abflat {

/// A surface that has been cut, with what fills the holes that stay filled behind it.
struct FilledTable {
  CornerTable table;  ///< no twins across seams
  std::size_t surfaceTriangles = 0;
  std::vector<HoleId> hole;  ///< that each triangle behind those fills
};

/// A hole stays filled where no edge of what fills it is a seam. `vertices` are those of the mesh
/// that the vertices of `mesh` belong to.
FilledTable filledTable(const SeamMesh& mesh, const IdVector<SurfaceVertex, InputVertex>& vertices,
                        const Seams& seams);

}  // namespace abflat
