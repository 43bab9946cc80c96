#pragma once

#include "seam/seam_work.h"

namespace abflat {

/// Takes seams back from where they end, as far as the bound allows: those first that a chart's
/// stretch depends on least for their length. `isSolved`: the scale has last been solved for the
/// seams as they are.
void shortenSeams(const SeamWork& work, bool isSolved = false);

}  // namespace abflat
