#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "pack/outline.h"

namespace abflat {

/// A straight cut across an outline, between two of its points.
struct OutlineChord {
  std::size_t from = 0, to = 0;  ///< from < to
  double length = 0;
  double share = 0;  ///< of the area, cut off by the part from `from` to `to`

  double smallerShare() const { return std::min(share, 1 - share); }
};

/// Cuts that may make an outline fit better. Among those that cut off a similar share, at the same
/// end and across or along, only the shortest. `mayEnd`: the points where cuts may end; empty: all.
std::vector<OutlineChord> outlineChords(const std::vector<PlanePoint>& outline,
                                        const std::vector<std::uint8_t>& mayEnd = {});

}  // namespace abflat
