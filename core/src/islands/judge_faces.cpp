#include "islands/judge_faces.h"

#include "exact/orientation.h"
#include "exact/overlap.h"
#include "islands/island_triangles.h"

namespace abflat {
namespace {

constexpr std::uint8_t bitOf(UvFault fault) { return static_cast<std::uint8_t>(fault); }

bool isOutside(const double* triangle, std::uint32_t tiles) {
  UvBox box;
  for (std::size_t k = 0; k < 3; ++k) box.add(triangle + 2 * k);
  return !isInTile(box, tiles);
}

}  // namespace

std::uint8_t faultsAt(const double* uv, bool isOverlapping, bool isOutside) {
  const int turn = orientation(uv, uv + 2, uv + 4);
  return static_cast<std::uint8_t>(
      (isOverlapping ? bitOf(UvFault::Overlapping) : 0) | (turn < 0 ? bitOf(UvFault::Flipped) : 0) |
      (turn == 0 ? bitOf(UvFault::Empty) : 0) | (isOutside ? bitOf(UvFault::Outside) : 0));
}

std::vector<std::uint8_t> faultsOf(const PlacedTriangles& placed, std::uint32_t tiles) {
  std::vector<std::uint8_t> out = overlappingTriangles(placed.uv);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double* t = &placed.uv[6 * i];
    out[i] = faultsAt(t, out[i] != 0, isOutside(t, tiles));
  }
  return out;
}

}  // namespace abflat
