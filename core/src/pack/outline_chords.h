#pragma once

#include "pack/outline.h"

namespace abflat {

/// A straight cut across an outline, between two of its points.
struct OutlineChord {
  std::size_t from = 0, to = 0;  ///< from < to
  double length = 0;
  double share = 0;  ///< of the area, of the part from one to the other
};

/// Cuts that may make an outline fit better: of those that part off about as much, at the same
/// end, and across or along, the shortest.
std::vector<OutlineChord> outlineChords(const std::vector<PlanePoint>& outline);

}  // namespace abflat
