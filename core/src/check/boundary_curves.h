#pragma once

#include <cstdint>
#include <vector>

#include "check/covered_once.h"

namespace abflat {

/// Boundaries of charts, from their triangles alone.
struct BoundaryCurves {
  Curves curves;
  std::vector<std::uint32_t> chart;   ///< per curve
  std::vector<std::uint32_t> broken;  ///< charts whose boundary is not a set of curves: an edge has
                                      ///< more than one triangle on one side
  /// Whether charts are left out because some of their curves share a corner, as when a hole
  /// touches the outline.
  bool arePinched = false;
};

/// `triangles` has 3 texcoords each. Triangles of charts that are not `wanted` and those with two
/// equal texcoords are ignored.
BoundaryCurves boundaryCurves(const std::vector<double>& uv,
                              const std::vector<std::uint32_t>& triangles,
                              const std::vector<std::uint32_t>& chartOf,
                              const std::vector<std::uint8_t>& isWanted);

}  // namespace abflat
