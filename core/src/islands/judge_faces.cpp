#include "islands/judge_faces.h"

#include "abflat/generated/names.h"
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

std::vector<std::uint8_t> faultsOf(const PlacedTriangles& placed, std::uint32_t tiles) {
  std::vector<std::uint8_t> out = overlappingTriangles(placed.uv);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double* t = &placed.uv[6 * i];
    const int turn = orientation(t, t + 2, t + 4);
    out[i] = static_cast<std::uint8_t>((out[i] != 0 ? bitOf(UvFault::Overlapping) : 0) |
                                       (turn < 0 ? bitOf(UvFault::Flipped) : 0) |
                                       (turn == 0 ? bitOf(UvFault::Empty) : 0) |
                                       (isOutside(t, tiles) ? bitOf(UvFault::Outside) : 0));
  }
  return out;
}

void countFaults(const PlacedTriangles& placed, const std::vector<std::uint8_t>& faults,
                 PackReport& report) {
  for (std::size_t i = 0; i < faults.size();) {
    unsigned ofFace = 0;
    const std::uint32_t face = placed.face[i];
    for (; i < faults.size() && placed.face[i] == face; ++i) ofFace |= faults[i];
    const auto has = [&](UvFault fault) { return std::size_t{(ofFace & bitOf(fault)) != 0}; };
    report.facesOverlapping += has(UvFault::Overlapping);
    report.facesFlipped += has(UvFault::Flipped);
    report.facesEmpty += has(UvFault::Empty);
    report.facesOutside += has(UvFault::Outside);
  }
}

}  // namespace abflat
