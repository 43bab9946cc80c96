#pragma once

#include <cstdint>
#include <vector>

namespace abflat {

/// The inside of a polygon that uses places several times, as loops of its corners with the inside
/// on their left: each piece has its outline, its holes and the bridges between them in one loop,
/// which is the polygon itself where that has one piece. Corners that bound nothing are in none.
/// Empty where the polygon crosses itself or winds round a place twice, seen in its own plane.
/// `places`: vertex per corner.
std::vector<std::vector<std::uint32_t>> insideLoops(const std::vector<double>& positions,
                                                    const std::vector<std::uint32_t>& places);

/// Whether one of the loops, which are of a polygon's corners, runs the other way round than the
/// polygon does: there may be a hole in it.
bool hasReversed(const std::vector<double>& positions, const std::vector<std::uint32_t>& places,
                 const std::vector<std::vector<std::uint32_t>>& loops);

}  // namespace abflat
