#pragma once

#include "abflat/unwrap.h"
#include "base/listener.h"
#include "mesh/surface.h"
#include "seam/scale_seams.h"
#include "unwrap/fixed.h"
#include "unwrap/open_surface.h"

namespace abflat {

/// A surface before it is cut.
struct UncutSurface {
  const WeldedMesh& welded;
  double unit;  ///< of the welded mesh, in units of the input
  const Surface& surface;
  const FixedTriangles& fixed;  ///< what stays as it is
};

/// Where the surface has to be cut, whatever else is found.
struct AskedCuts {
  Seams seams;
  Seams breaks;  ///< as in SeamMesh, cut or not
  Scales scales;
  std::size_t upAxis = 1;
};

/// Opens the surface along the given seams, so that the holes of its charts show, and fills these
/// holes. Without holes the surface stays as it is, so that its elimination order does not depend
/// on the given seams. The result's seams are those given that are not on its boundary.
OpenSurface openAndFill(const UncutSurface& uncut, const AskedCuts& asked,
                        const UnwrapOptions& options, const Listener& listener);

}  // namespace abflat
