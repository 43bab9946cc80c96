#pragma once

#include "seam/seam_work.h"

namespace abflat {

/// Takes seams back from their ends, as far as the bound allows, preferring those on which a
/// chart's stretch depends least for their length. `isSolved`: the scale's last solution is for the
/// seams as they are.
void shortenSeams(const SeamWork& work, bool isSolved = false);

}  // namespace abflat
