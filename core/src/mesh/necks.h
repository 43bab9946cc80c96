#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/triangle_geometry.h"

namespace abflat {

/// How far an opened corner moves, relative to the shortest edge at its place: far enough for what
/// it opens to survive the precision of files, near enough not to be seen.
constexpr double kOpening = 0x1p-11;

/// Corners of a polygon at places where it is opened.
struct Opening {
  struct Corner {
    std::uint32_t corner, point;  ///< index into `points`, or kNone if it stays
  };
  std::vector<Corner> corners;
  std::vector<Vec3> points;
};

/// Where pieces of a polygon's inside meet in a place, the outside around it falls into parts. Each
/// part moves away from the others, so that the pieces hang together between them. `bounds`: per
/// corner, whether it is in a loop of the inside. Nothing if that does not make the polygon simple.
std::optional<Opening> openNecks(const std::vector<double>& positions,
                                 const std::vector<std::uint32_t>& places,
                                 const std::vector<std::uint8_t>& bounds);

/// Gives each of `corners` a point of its own, a little to the right of the way.
Opening openEach(const std::vector<double>& positions, const std::vector<std::uint32_t>& places,
                 const std::vector<std::uint32_t>& corners);

}  // namespace abflat
