#pragma once

#include <vector>

#include "abflat/unwrap.h"
#include "unwrap/open_surface.h"

namespace abflat {

/// All visible seams, including the given ones, per half-edge of the surface.
Seams visibleSeams(const OpenSurface& open);

/// Length of all visible seams, divided by the root of the area.
double seamLength(const OpenSurface& open);

/// The same for what they cost, see SeamMesh.
double seamCost(const OpenSurface& open);

/// Sets the number of seam edges and their length.
void measureSeams(const OpenSurface& open, const Seams& visible, SeamSummary& summary);
void measureSeams(const std::vector<double>& positions, const CornerTable& table,
                  const Seams& visible, SeamSummary& summary);

}  // namespace abflat
