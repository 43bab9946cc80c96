#pragma once

#include "abflat/atlas_size.h"
#include "islands/island_triangles.h"
#include "verify/chart_gaps.h"

namespace abflat {

/// The edges of islands that only one of their triangles has, by the places of their ends, in
/// texels. `isLeftOut`: per island.
OutlineEdges outlineEdges(const IslandTriangles& islands, const AtlasSize& size,
                          const std::vector<std::uint8_t>& isLeftOut);

}  // namespace abflat
