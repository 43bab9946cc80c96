#pragma once

#include <string>
#include <vector>

#include "unwrap/open_and_fill.h"

namespace abflat {

/// What of a surface may be cut, has to be cut, and stays as it is.
struct AskedParts {
  AskedCuts cuts;
  FixedTriangles fixed;
};

/// Errors: those of givenSeams and fixedTriangles.
Result<AskedParts> askedParts(const SurfaceMap& map, const UnwrapOptions& options, double unit,
                              std::size_t upAxis, std::vector<std::string>& notes);

}  // namespace abflat
