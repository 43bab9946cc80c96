#pragma once

#include "seam/find_seams.h"
#include "seam/log_scale.h"

namespace abflat {

/// The seams of a whole mesh that are being improved.
struct SeamWork {
  const SeamMesh& mesh;
  const Seams& kept;  ///< seams that must stay
  const SeamOptions& options;
  LogScale& scale;  ///< of the whole mesh; may have been solved for anything
  LogScales& u;     ///< of the current charts, both before and after the work
  Seams& seams;
};

}  // namespace abflat
