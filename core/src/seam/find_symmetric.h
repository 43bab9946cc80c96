#pragma once

#include "seam/find_seams.h"

namespace abflat {

/// For a mesh without cuts so far: replaces `seams`, which `report` describes, by some that are
/// symmetric to the mesh's plane of symmetry, if there are any that options.symmetricSeams prefers.
void preferSymmetric(const SeamMesh& mesh, const SeamOptions& options, Seams& seams,
                     SeamReport& report);

}  // namespace abflat
