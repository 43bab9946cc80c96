#pragma once

#include <vector>

#include "mesh/surface_map.h"
#include "unwrap/stacks.h"
#include "unwrap/unseen.h"

namespace abflat {

/// A mesh whose equal positions are merged, and its triangles.
struct WeldedSurface {
  WeldedMesh welded;
  Surface surface;
};

/// `unit`: what a length of 1 is to be in the mesh. A pulse that has stopped leaves nothing to be
/// used. Sets what the report says of the input. Errors: EmptyMesh.
Result<WeldedSurface> readSurface(const PolygonMesh& input, const UnwrapOptions& options,
                                  double unit, const Pulse& pulse, UnwrapReport& report);

/// What of a surface may be cut, has to be cut, and stays as it is.
struct AskedParts {
  AskedCuts cuts;
  FixedTriangles fixed;
};

/// Errors: those of givenSeams and fixedTriangles.
Result<AskedParts> askedParts(const SurfaceMap& map, const UnwrapOptions& options, double unit,
                              std::size_t upAxis, std::vector<std::string>& notes);

}  // namespace abflat
