#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pack/pack.h"

namespace abflat::test {

/// Texels (x, y) of each chart in turn that its triangles touch, found triangle by triangle and
/// texel by texel. Those that are only nearly touched count too.
using Texels = std::vector<std::pair<int, int>>;
Texels touchedTexels(const std::vector<double>& uv, const std::vector<std::uint32_t>& triangles,
                     double resolution);

/// The coordinates of a chart in its tile, rounded to single precision on request.
std::vector<double> placed(const PackShape& shape, const Placement& placement, bool toSingle);

/// What the texels say against a packing; empty when it is as promised.
std::string complaint(const std::vector<PackShape>& shapes, const Packing& packing,
                      const PackOptions& options, bool toSingle = false);

}  // namespace abflat::test
