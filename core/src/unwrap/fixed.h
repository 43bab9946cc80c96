#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "unwrap/known.h"

namespace abflat {

/// Triangles of the surface that keep their given texcoords; always whole uv islands.
struct FixedTriangles {
  IdVector<SurfaceTriangle, std::uint8_t> isFixed;  ///< empty: none is fixed
  Seams borders;                                    ///< of these islands
  std::vector<double> texcoords;                    ///< given ones, 2 numbers each
  std::vector<std::uint32_t> ofCorner;              ///< by InputCorner, or kNoTexcoord
  std::string note;                                 ///< which islands do not stay; may be empty
};

/// The islands of `options.reuse.fixedFaces`, and known charts that are fixed. Errors:
/// InvalidOption, naming a face or chart that does not exist, or a face that has no texcoords. With
/// `options.reuse.keepsValidOnly`, islands that cannot stay are not fixed.
Result<FixedTriangles> fixedTriangles(const SurfaceMap& map, const UnwrapOptions& options);

/// Sets the layouts of fixed charts. Errors, unless `options` keep places whatever is there:
/// InvalidOption, naming a face that is flipped, overlaps another one or is not inside a tile.
Status layOutFixed(const CutMesh& mesh, const FixedTriangles& fixed, const UnwrapOptions& options,
                   FlatCharts& flat);

}  // namespace abflat
