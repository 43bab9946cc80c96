#pragma once

#include "abflat/generated/unwrap_options.h"
#include "cut/cut_surface.h"

namespace abflat {

/// Adds triangles without area that fill holes: boundary loops of a chart other than its longest
/// one. Those that cannot be triangulated stay open. Seams through what fills cost nothing, or
/// kBarredCost with FillHoles::Always. `isFixed`: per triangle of charts that are left as they
/// are; may be empty.
void fillHoles(FillHoles mode, const IdVector<SurfaceTriangle, std::uint8_t>& isFixed,
               SeamMesh& mesh, const Pulse& pulse = {});

/// Opens the holes that seams have come to: their rims become seams, so that what filled them is
/// apart. With FillHoles::Always only those that seams run through. Returns whether there were any.
/// What is taken away from a disk touches its boundary in one place, so a disk is left, or several.
bool openTouchedHoles(const SeamMesh& mesh, const CutSurface& surface, FillHoles mode,
                      Seams& seams);

}  // namespace abflat
