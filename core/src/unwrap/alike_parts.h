#pragma once

#include "alike/find_alike.h"
#include "unwrap/fixed.h"
#include "unwrap/laid_charts.h"

namespace abflat {

/// Faces of the input that have been found not to fit where they would lie.
using UnfitFaces = std::vector<std::uint32_t>;

/// Finds the components of the surface that are alike: with the same given seams, material and
/// density, and nothing fixed or pinned. Empty if no two are.
CornerMatch alikeComponents(const SurfaceMap& map, const Seams& given, const FixedTriangles& fixed,
                            const UnwrapOptions& options, const UnfitFaces& unfit);

/// Finds the charts that are alike: with the same straight lines, material and density, valid and
/// not fixed. Empty if no two are.
CornerMatch alikeCharts(const CutMesh& mesh, const IdVector<ChartId, ChartConstraints>& constraints,
                        const FlatCharts& flat, const UnwrapOptions& options,
                        const UnfitFaces& unfit);

/// Per triangle of a surface, whether it is part of a model, or of a part like no other.
IdVector<SurfaceTriangle, std::uint8_t> areModels(const Surface& surface, const CornerMatch& model);

}  // namespace abflat
