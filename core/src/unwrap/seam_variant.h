#pragma once

#include "seam/vary_costs.h"
#include "unwrap/open_and_fill.h"

namespace abflat {

/// How far charts may be stretched where a search begins.
enum class SeamBound {
  Asked,
  Tighter,  ///< half as far beyond 1
  Exact,    ///< not at all: only what unrolls is a chart
};

/// Which of several searches for seams it is.
struct SeamVariant {
  int costs = 0;  ///< see varyCosts
  SeamBound bound = SeamBound::Asked;
  bool isUncut = false;                 ///< only what is needed to lie flat, however stretched
  const OpenSurface* before = nullptr;  ///< what another search found; null: this is the first one
};

/// Whether it is made because people look at some of the seams.
inline bool isForFront(const SeamVariant& variant) {
  return variant.isUncut || isForFront(variant.costs);
}

}  // namespace abflat
