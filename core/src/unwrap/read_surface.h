#pragma once

#include "abflat/unwrap.h"
#include "base/listener.h"
#include "mesh/surface_map.h"

namespace abflat {

/// A mesh whose equal positions are merged, and its triangles.
struct WeldedSurface {
  WeldedMesh welded;
  Surface surface;
};

/// `unit`: what a length of 1 is to be in the mesh. A listener that has stopped leaves nothing to
/// be used. Sets what the report says of the input. Errors: EmptyMesh.
Result<WeldedSurface> readSurface(const InputMesh& input, const UnwrapOptions& options, double unit,
                                  const Listener& listener, UnwrapReport& report);

}  // namespace abflat
