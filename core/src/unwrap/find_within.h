#pragma once

#include "seam/extract_charts.h"
#include "unwrap/open_surface.h"

namespace abflat {

/// Finds new seams within a part of the surface, starting from those that were found before. False
/// if nothing has changed.
bool findWithin(const SeamPart& part, SeamOptions options, OpenSurface& open, SeamReport& found);

}  // namespace abflat
