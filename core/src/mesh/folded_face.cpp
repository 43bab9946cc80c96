#include "mesh/folded_face.h"

namespace abflat {

std::vector<std::array<std::uint32_t, 3>> foldedTriangles(
    const std::vector<std::uint32_t>& places) {
  std::vector<std::array<std::uint32_t, 3>> out;
  std::vector<std::uint32_t> path;  // remaining corners
  for (std::uint32_t c = 0; c < places.size(); ++c) {
    const auto isBack = [&](std::size_t steps) {
      return path.size() >= 2 && places[path[path.size() - steps]] == places[c];
    };
    while (isBack(1) || isBack(2)) {
      out.push_back({path[path.size() - 2], path.back(), c});
      path.pop_back();
    }
    path.push_back(c);
  }
  for (std::size_t k = 1; k + 1 < path.size(); ++k) out.push_back({path[0], path[k], path[k + 1]});
  return out;
}

}  // namespace abflat
