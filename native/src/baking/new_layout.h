#pragma once

#include <cstdint>
#include <vector>

#include "abflat/atlas_size.h"

namespace abflat::cli {

/// The layout that textures are to follow, as it is written.
struct NewLayout {
  const std::vector<double>& uv;               ///< v upwards
  const std::vector<std::uint32_t>& ofCorner;  ///< per face corner, once faces were turned
  const std::vector<std::uint32_t>& turnedFaces;
  int padding = 0;       ///< in texels, or in those of the resolution if there is one
  AtlasSize resolution;  ///< that it was packed for; 0 x 0: unknown
};

}  // namespace abflat::cli
