#include "islands/check_places.h"

#include <cmath>

#include "exact/overlap.h"

namespace abflat {

bool isInTile(const UvBox& box, std::uint32_t tiles) {
  const double column = std::floor(box.low[0]), row = std::floor(box.low[1]);
  return column >= 0 && column < 10 && row >= 0 && 10 * row + column < tiles &&
         box.high[0] <= column + 1 && box.high[1] <= row + 1;
}

std::string problemOf(const PlacedTriangles& placed, std::uint32_t tiles) {
  std::vector<UvBox> boxes;
  for (std::size_t t = 0; t < placed.stack.size(); ++t) {
    if (boxes.size() <= placed.stack[t]) boxes.resize(placed.stack[t] + 1);
    for (std::size_t k = 0; k < 3; ++k) boxes[placed.stack[t]].add(&placed.uv[6 * t + 2 * k]);
  }
  for (std::size_t t = 0; t < placed.stack.size(); ++t)
    if (!isInTile(boxes[placed.stack[t]], tiles))
      return "the island of face " + std::to_string(placed.face[t]) + " leaves its tile";
  const auto pair = findOverlapBetween(placed.uv, placed.stack);
  if (!pair) return {};
  return "the islands of faces " + std::to_string(placed.face[(*pair)[0]]) + " and " +
         std::to_string(placed.face[(*pair)[1]]) + " overlap, which lay apart";
}

}  // namespace abflat
