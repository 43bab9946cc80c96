#pragma once

#include <cstdint>
#include <vector>

#include "mesh/inside_loops.h"
#include "mesh/necks.h"

namespace abflat {

/// The way around a face as one polygon, however often the face touches itself.
struct FaceWalk {
  /// In order, without repetitions in a row and without spikes: ways there and back again that
  /// bound nothing. Fewer than three if the face has no area.
  CornerLoop corners;
  /// Per corner of the face: itself, or the one at the same place that stands for it if it is left
  /// out. That one may be left out as well.
  CornerLoop same;
  /// Of `corners`, those that move to make the polygon simple.
  Opening opening;
};

/// `places`: vertex per corner of the face.
FaceWalk walkAround(const std::vector<double>& positions, const std::vector<std::uint32_t>& places);

}  // namespace abflat
