#pragma once

#include <vector>

#include "abflat/status.h"
#include "pack/pack.h"

namespace abflat {

/// In texels, along either side of a tile.
constexpr int kMostResolution = 32768;

/// Errors: InvalidOption.
Status checkPackOptions(const PackOptions& options);

/// Errors: InvalidMesh.
Status checkPackShapes(const std::vector<PackShape>& shapes);

}  // namespace abflat
