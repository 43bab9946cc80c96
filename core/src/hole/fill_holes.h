#pragma once

#include "abflat/generated/unwrap_options.h"
#include "cut/cut_surface.h"

namespace abflat {

/// Adds triangles without area that fill holes, which are a chart's boundary loops other than its
/// longest one. Holes that cannot be triangulated stay open. Seams through a filling cost nothing,
/// or kBarredCost with FillHoles::Always. `isFixed`: per triangle, whether its chart is left as it
/// is; may be empty.
void fillHoles(FillHoles mode, const IdVector<SurfaceTriangle, std::uint8_t>& isFixed,
               SeamMesh& mesh, const Listener& listener = {});

/// Opens the holes that seams have reached: their rims become seams, which separates their
/// fillings. With FillHoles::Always, only those that seams pass through, and those whose fillings
/// alone join parts of the surface: these would be islands without a common scale. Returns whether
/// there were any. A filling removed from a disk touches the disk's boundary in one place, so what
/// remains is one disk or several.
bool openTouchedHoles(const SeamMesh& mesh, const CutSurface& surface, FillHoles mode,
                      Seams& seams);

}  // namespace abflat
