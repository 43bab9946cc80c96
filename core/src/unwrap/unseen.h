#pragma once

#include "abflat/unwrap.h"
#include "base/pulse.h"
#include "mesh/smooth_noise.h"
#include "mesh/surface.h"
#include "mesh/welded_mesh.h"

namespace abflat {

/// Edges that are shorter, in units of the welded mesh, are so fine that steps of the surface bend
/// them at random.
double fineLength(const WeldedMesh& welded, const Surface& surface, const UnwrapOptions& options,
                  double unit);

/// The surface without steps and grain that the texels of the atlas cannot show, which would cost
/// seams. Nothing is smoothed where parts of the mesh have texcoords already. `unit`: of the welded
/// mesh, in units of the input.
Smoothed withoutUnseen(const WeldedMesh& welded, const Surface& surface,
                       const UnwrapOptions& options, double unit, const Pulse& pulse);

/// Empty if nothing is smoothed.
std::string unseenNote(const Smoothed& smoothed);

}  // namespace abflat
