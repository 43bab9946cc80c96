#pragma once

#include "alike/find_alike.h"
#include "unwrap/fixed.h"
#include "unwrap/kept.h"

namespace abflat {

/// Which parts of the surface lie on others. Only one of each kind is cut, laid out and packed.
struct Stacks {
  Surface whole;      ///< before parts were left out
  CornerMatch model;  ///< per corner of its polygons, the one whose uv it gets

  bool isAny() const { return !model.empty(); }
};

/// Faces of the input that have been found not to fit where they would lie.
using UnfitFaces = std::vector<std::uint32_t>;

/// Whether charts may be stacked at all. Those of an earlier run stay as they are.
bool mayStack(const UnwrapOptions& options);

/// Finds the components of the surface that are alike: with the same given seams, material and
/// density, and nothing fixed or pinned. Empty if no two are.
CornerMatch alikeComponents(const SurfaceMap& map, const Seams& given, const FixedTriangles& fixed,
                            const UnwrapOptions& options, const UnfitFaces& unfit);

/// Finds the charts that are alike.
CornerMatch alikeCharts(const CutMesh& mesh, const IdVector<ChartId, ChartWishes>& wishes,
                        const FlatCharts& flat, const UnwrapOptions& options,
                        const UnfitFaces& unfit);

/// Per triangle of a surface, whether it is part of a model.
IdVector<SurfaceTriangle, std::uint8_t> areModels(const Surface& surface, const CornerMatch& model);

/// Adds what has been found within the models of `stacks`.
void addMatch(const CornerMatch& found, Stacks& stacks);

}  // namespace abflat
