#pragma once

#include <string>

#include "abflat/unwrap.h"
#include "mesh/surface_map.h"
#include "seam/scale_seams.h"
#include "unwrap/open_surface.h"

namespace abflat {

/// A note that the surface is cut between two faces. `unit`: what a length of 1 is in the mesh.
std::string scaleNote(const ScaleJump& jump, const SurfaceMap& map, double unit);

/// A note if seams should be symmetric, but are not; empty otherwise.
std::string asymmetryNote(const OpenSurface& open, const UnwrapOptions& options);

}  // namespace abflat
