#pragma once

#include "cut/cut_surface.h"

namespace abflat {

/// The creases of components that may be taken apart along them to begin with; empty if there are
/// none. `whole`: the surface with given seams only. Components below the least area are too small
/// for that.
Seams creasesToBegin(const SeamMesh& mesh, const CutSurface& whole, double leastArea);

}  // namespace abflat
