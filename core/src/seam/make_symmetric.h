#pragma once

#include "seam/seam_work.h"

namespace abflat {

/// Replaces the seams on one side of options.mirror by the images of those on the other side,
/// whichever costs less, unless charts are stretched too much then or cover themselves. True if the
/// scale has been solved for anything.
bool makeSymmetric(const SeamWork& work);

}  // namespace abflat
