// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include "abflat/unwrap.h"

namespace abflat::bindings {

/// Arrays among the options of unwrap.
enum class UnwrapArray : int {
  SeamEdges = 0,  ///< edges to cut in addition, given as two input vertices each
  FixedFaces = 1,  ///< input faces whose uv islands stay exactly as they are, or `'uv'` for all that have texcoords; all others are packed around them
  FixedCharts = 2,  ///< charts of `known` that stay exactly where they are; all others are packed around them
  FaceDensities = 3,  ///< per input face, the texel density wanted for it relative to the others, from 0.001 to 1000; a chart has as many texels as its faces ask for together, and charts that stay where they are also keep their size
};

/// What `take` returns for the array.
template <class Take>
auto takeArray(UnwrapOptions& options, UnwrapArray which, const Take& take) {
  switch (which) {
    case UnwrapArray::SeamEdges:
      return take(options.seams.edges);
    case UnwrapArray::FixedFaces:
      return take(options.reuse.fixedFaces);
    case UnwrapArray::FixedCharts:
      return take(options.reuse.fixedCharts);
    case UnwrapArray::FaceDensities:
      return take(options.faceDensities);
  }
  return take(options.seams.edges);
}

}  // namespace abflat::bindings
