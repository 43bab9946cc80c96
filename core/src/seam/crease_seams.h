#pragma once

#include "seam/find_seams.h"

namespace abflat {

/// Edges along which a surface may be taken apart to begin with; empty if it has hardly any.
Seams creasesToBegin(const SeamMesh& mesh);

}  // namespace abflat
