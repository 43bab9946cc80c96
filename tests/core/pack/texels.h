#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pack/pack.h"

namespace abflat::test {

/// Texels (x, y) that the triangles of one chart touch, found triangle by triangle and texel by
/// texel. Texels that are only almost touched count as well.
using Texels = std::vector<std::pair<int, int>>;
Texels touchedTexels(const std::vector<double>& uv, const std::vector<std::uint32_t>& triangles,
                     const AtlasSize& resolution);

/// The coordinates of a chart in its tile, rounded to single precision if asked.
std::vector<double> placed(const PackShape& shape, const Placement& placement, bool toSingle);

/// What is wrong with a packing, judged by its texels; empty if it keeps its promises.
std::string complaint(const std::vector<PackShape>& shapes, const Packing& packing,
                      const PackOptions& options, bool toSingle = false);

}  // namespace abflat::test
