#pragma once

#include "seam/find_seams.h"
#include "seam/log_scale.h"

namespace abflat {

/// The seams of a mesh that are being improved.
struct SeamWork {
  const SeamMesh& mesh;
  const Seams& kept;  ///< seams that must stay
  const SeamOptions& options;
  LogScale& scale;  ///< of the mesh; may have been solved for anything
  LogScales& u;     ///< of the current charts, both before and after the work
  Seams& seams;
  double area = mesh.totalArea();  ///< of all that shares the atlas
};

}  // namespace abflat
