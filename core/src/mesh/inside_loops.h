#pragma once

#include <cstdint>
#include <vector>

namespace abflat {

/// Corners of a face, or of a part of one.
using CornerLoop = std::vector<std::uint32_t>;

/// The inside of a polygon that visits places several times.
struct Inside {
  /// Loops of its corners with the inside on their left. Each piece has its outline, its holes and
  /// the bridges between them in one loop. Corners that bound nothing are in no loop. Empty if the
  /// polygon, seen in its own plane, crosses itself, winds around a place twice or has no area.
  std::vector<CornerLoop> loops;
};

/// `places`: vertex per corner, never the same one twice in a row.
Inside insideLoops(const std::vector<double>& positions, const std::vector<std::uint32_t>& places);

}  // namespace abflat
