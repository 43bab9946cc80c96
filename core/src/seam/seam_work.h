#pragma once

#include "seam/find_seams.h"
#include "seam/log_scale.h"

namespace abflat {

/// Seams of a whole mesh, which are being improved.
struct SeamWork {
  const SeamMesh& mesh;
  const Seams& kept;  ///< seams that stay
  const SeamOptions& options;
  LogScale& scale;  ///< of the whole, whatever it has been solved for
  LogScales& u;     ///< of the charts as they are, before and after
  Seams& seams;

  bool goesOn() const { return !options.keepsOn || options.keepsOn(); }
};

}  // namespace abflat
