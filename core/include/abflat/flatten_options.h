#pragma once

#include <cstdint>
#include <vector>

#include "abflat/generated/flatten_options.h"
#include "abflat/generated/vertex_bound.h"
#include "abflat/pins.h"
#include "abflat/progress.h"

namespace abflat {

/// A part of the boundary that is to be straight in the layout: what follows `from`, with the
/// surface on the left, up to `to`. Both are input vertices and may be corners themselves.
struct StraightRun {
  std::uint32_t from = 0, to = 0;
};

struct FlattenOptions : FlattenOptionValues {
  std::vector<VertexBound> bounds;
  /// Angles inside of these are exactly pi, whatever t and the bounds say.
  std::vector<StraightRun> straight;
  /// None, or two and more. Two are met by turning and scaling the layout; of the layouts that meet
  /// more, the nearest to the angles in the sense of least squares is taken.
  std::vector<Pin> pins;
  ProgressCallback progress;
};

}  // namespace abflat
