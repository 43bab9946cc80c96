#pragma once

#include <cstdint>
#include <vector>

#include "abflat/generated/flatten_options.h"
#include "abflat/generated/vertex_bound.h"
#include "abflat/pins.h"
#include "abflat/progress.h"

namespace abflat {

/// A part of the boundary that is to be straight in the layout. It runs from `from` to `to` with
/// the surface on the left. Both are input vertices and may be corners themselves.
struct StraightRun {
  std::uint32_t from = 0, to = 0;
};

struct FlattenOptions : FlattenOptionValues {
  std::vector<VertexBound> bounds;
  /// Angles strictly inside these runs are exactly pi, whatever t and the bounds say.
  std::vector<StraightRun> straight;
  /// Either none, or at least two. Two are met by rotating and scaling the layout; with more, the
  /// layout that meets them and is nearest to the angles in the least-squares sense is taken.
  std::vector<Pin> pins;
  ProgressCallback progress;
};

}  // namespace abflat
