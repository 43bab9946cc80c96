#include "mesh/arms.h"

#include <array>

#include "base/stable_order.h"

namespace abflat {

std::vector<Arm> armsAround(const std::vector<Point2>& points, const std::uint32_t* begin,
                            const std::uint32_t* end) {
  const auto count = static_cast<std::uint32_t>(points.size());
  const Clockwise clockwise{points[*begin]};
  std::vector<Arm> arms;
  for (const std::uint32_t* k = begin; k != end; ++k) {
    arms.push_back({*k, false, points[*k == 0 ? count - 1 : *k - 1]});
    arms.push_back({*k, true, points[*k + 1 == count ? 0 : *k + 1]});
  }
  for (const Arm& arm : arms)
    if (arm.end == clockwise.at) return {};
  sortStably(arms, clockwise);
  for (std::size_t i = 0, last = 0; i < arms.size(); i = last) {
    std::array<std::uint32_t, 2> turns{0, 0};
    for (; last < arms.size() && clockwise.compare(arms[i].end, arms[last].end) == 0; ++last)
      arms[last].turn = turns[arms[last].isOut]++;
  }
  sortStably(arms, clockwise);
  return arms;
}

}  // namespace abflat
