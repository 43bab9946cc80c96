#pragma once

#include <cstdint>
#include <vector>

namespace abflat {

/// Corners of a face, or of a part of one.
using CornerLoop = std::vector<std::uint32_t>;

/// The inside of a polygon that visits places several times, as loops of its corners with the
/// inside on their left. Each piece has its outline, its holes and the bridges between them in one
/// loop; a polygon with a single piece is that loop itself. Corners that bound nothing are in no
/// loop. Empty if the polygon, seen in its own plane, crosses itself or winds around a place twice.
/// `places`: vertex per corner.
std::vector<CornerLoop> insideLoops(const std::vector<double>& positions,
                                    const std::vector<std::uint32_t>& places);

/// Whether one of the loops of a polygon's corners runs the opposite way to the polygon, which
/// means that it may be a hole.
bool hasReversed(const std::vector<double>& positions, const std::vector<std::uint32_t>& places,
                 const std::vector<CornerLoop>& loops);

}  // namespace abflat
