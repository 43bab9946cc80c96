#pragma once

#include <cstdint>
#include <vector>

#include "unwrap_known.h"

namespace abflat {

/// Triangles of the surface that keep the texcoords of the input: those of whole uv islands.
struct FixedTriangles {
  std::vector<std::uint8_t> isFixed;  ///< per triangle of the surface; empty: none is
  Seams borders;                      ///< of these islands
};

/// The islands of `faces`. Errors: InvalidOption names a face that does not exist or that has no
/// texcoords.
Result<FixedTriangles> fixedTriangles(const PolygonMesh& input, const WeldedMesh& welded,
                                      const Surface& surface,
                                      const std::vector<std::uint32_t>& faces);

/// Sets the layouts of fixed charts. Errors: InvalidOption names a face that is flipped, overlapped
/// by another one, or not in a tile, of which there are several with `hasTiles`.
Status layOutFixed(const CutMesh& mesh, const FixedTriangles& fixed, bool hasTiles,
                   std::vector<FlatChart>& flat);

}  // namespace abflat
