#pragma once

#include "seam/seam_work.h"

namespace abflat {

/// Draws seams anew where that makes them cheaper or straighter, as far as no chart goes beyond its
/// bounds for it. True when the scale has last been solved for the seams as they are now.
bool fairSeams(const SeamWork& work);

}  // namespace abflat
