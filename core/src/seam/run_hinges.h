#pragma once

#include "seam/run_images.h"

namespace abflat {

/// Parts of the runs along which charts could stay joined; for each run, those nearest to its
/// middle come first.
std::vector<SharedRun> hingesOf(const SeamMesh& mesh, const RunImages& images, const CutSurface& s,
                                const std::vector<SharedRun>& runs);

}  // namespace abflat
