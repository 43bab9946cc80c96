#include "mesh/uncross.h"

#include <numeric>
#include <utility>

#include "base/disjoint_sets.h"
#include "mesh/surroundings.h"

namespace abflat {
namespace {

/// Edges that come into a place, each with the next one clockwise, which leaves it, as corners.
std::vector<std::array<std::uint32_t, 2>> piecesAt(const Surroundings& place) {
  const std::vector<Arm>& arms = place.arms();
  std::vector<std::array<std::uint32_t, 2>> out;
  for (std::size_t i = arms[0].isOut ? 1 : 0; i < arms.size(); i += 2)
    out.push_back({arms[i].corner, arms[(i + 1) % arms.size()].corner});
  return out;
}

}  // namespace

CornerLoop uncross(const std::vector<double>& positions, const std::vector<std::uint32_t>& places,
                   const std::vector<std::uint8_t>& bounds) {
  const auto n = static_cast<std::uint32_t>(places.size());
  CornerLoop leaving(n);  // per corner at which the way arrives: the one that it leaves from
  std::iota(leaving.begin(), leaving.end(), 0u);
  const std::vector<Surroundings> all = surroundings(positions, places, bounds);
  std::vector<const Surroundings*> crossed;
  for (const Surroundings& place : all) {
    if (!place.isClear()) return {};
    if (!place.isPlain()) crossed.push_back(&place);
  }
  if (crossed.empty()) return leaving;
  // There the way is taken apart into pieces, none of which crosses another.
  for (const Surroundings* place : crossed)
    for (const auto& [in, out] : piecesAt(*place)) leaving[in] = out;
  const auto before = [n](std::uint32_t k) { return k == 0 ? n - 1 : k - 1; };
  DisjointSets ways(n);  // of edges
  for (std::uint32_t k = 0; k < n; ++k) ways.join(before(k), leaving[k]);
  // Pieces beside each other become one, unless they are on one way already.
  for (const Surroundings* place : crossed) {
    const auto pieces = piecesAt(*place);
    std::uint32_t first = pieces[0][0];
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      const auto [in, out] = pieces[i];
      if (ways.join(pieces[i - 1][1], out))
        std::swap(leaving[first], leaving[in]);
      else
        first = in;
    }
  }
  CornerLoop order;
  std::uint32_t k = 0;
  do {
    order.push_back(k);
    k = leaving[k + 1 == n ? 0 : k + 1];
  } while (k != 0 && order.size() <= n);
  return order.size() == n ? order : CornerLoop{};
}

}  // namespace abflat
