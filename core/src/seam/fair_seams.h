#pragma once

#include "seam/seam_work.h"

namespace abflat {

/// Redraws seams where that makes them cheaper or straighter, as long as no chart exceeds its
/// bounds because of it. True if the scale's last solution is for the seams as they are now.
bool fairSeams(const SeamWork& work);

}  // namespace abflat
