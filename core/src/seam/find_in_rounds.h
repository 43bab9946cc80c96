#pragma once

#include "seam/find_seams.h"

namespace abflat {

/// Cuts a mesh in rounds until no chart needs it, then joins, redraws and shortens. `given` and the
/// result are marked on both sides.
Seams findInRounds(const SeamMesh& mesh, Seams given, const SeamOptions& options,
                   SeamReport& report);

}  // namespace abflat
