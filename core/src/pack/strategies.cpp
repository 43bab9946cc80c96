#include "pack/strategies.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/stable_order.h"

namespace abflat {
namespace {

struct Effort {
  std::size_t items;  ///< for at most this many items
  int poses;
  std::size_t strategies;
  int angles;  ///< of every second strategy
};
constexpr Effort kEfforts[] = {
    {4, 64, 12, 4},         {10, 32, 20, 4},
    {kFewItems, 16, 20, 4}, {kSeveralItems, 8, 5, 4},
    {kManyItems, 8, 2, 4},  {std::numeric_limits<std::size_t>::max(), 4, 1, 2},
};

const Effort& effortFor(std::size_t items) {
  const Effort* effort = kEfforts;
  while (items > effort->items) ++effort;
  return *effort;
}

enum class Key { Box, Slim, Side };
constexpr Key kKeys[] = {Key::Box, Key::Slim, Key::Side};

double sizeOf(const PackItem& item, Key key) {
  if (item.poses.empty()) return 0;
  const Pose& pose = item.poses.base();
  const auto [height, width] = std::minmax(pose.width, pose.height);
  if (key == Key::Box) return width * height;
  if (key == Key::Slim) return width * std::sqrt(width * height);
  return width * width;
}

/// A number in [0, 1), different for each round and place in the order.
double disorder(std::uint64_t rank, std::uint64_t round) {
  std::uint64_t x = (rank + 1) * 0x9E3779B97F4A7C15u + round * 0xBF58476D1CE4E5B9u;
  x = (x ^ x >> 31) * 0x94D049BB133111EBu;
  return static_cast<double>((x ^ x >> 29) >> 11) * 0x1p-53;
}

/// Numbers by size, and by index only where that is equal.
std::vector<std::uint32_t> largestFirst(const std::vector<double>& size) {
  return stableOrder(size.size(),
                     [&](std::uint32_t a, std::uint32_t b) { return size[a] > size[b]; });
}

/// Largest first. Sizes are compared to nine digits of the largest, so that rounding errors do not
/// decide.
std::vector<std::uint32_t> ordered(const std::vector<PackItem>& items, Key key, unsigned round) {
  constexpr double kDigits = 1e9, kDisorder = 0.4;
  double largest = 0;
  for (const PackItem& item : items) largest = std::max(largest, sizeOf(item, key));
  std::vector<double> size;
  size.reserve(items.size());
  for (const PackItem& item : items)
    size.push_back(std::round(largest > 0 ? sizeOf(item, key) / largest * kDigits : 0));
  std::vector<std::uint32_t> order = largestFirst(size);
  if (round == 0) return order;
  for (std::size_t rank = 0; rank < order.size(); ++rank)
    size[order[rank]] *= 1 - kDisorder * disorder(rank, round);
  return largestFirst(size);
}

/// So many poses, evenly spread. If they are tidy, the level ones come first, and others only if
/// there are more than four.
std::vector<std::uint32_t> turnsOf(const std::vector<PackItem>& items, int angles, bool isTidy) {
  std::vector<std::uint32_t> out;
  if (items.empty()) return out;
  const Poses& poses = items[0].poses;
  const auto perQuarter = static_cast<std::uint32_t>(poses.perQuarter());
  const auto count = static_cast<std::uint32_t>(poses.size());
  const std::uint32_t first = poses.hasAdded() ? 1 : 0;
  const auto wanted = static_cast<std::uint32_t>(angles);
  if (isTidy && first > 0)
    for (std::uint32_t p = 0; p < count; p += perQuarter) out.push_back(p);
  if (!out.empty() && wanted <= 4) return out;
  const std::uint32_t step = std::max(4 * (perQuarter - first) / wanted, 1u);
  const std::uint32_t quarters = wanted == 2 ? 2 : 1;  // in a step
  for (std::uint32_t q = 0; q < count; q += quarters * perQuarter)
    for (std::uint32_t p = first; p < perQuarter; p += step) out.push_back(q + p);
  return out;
}

}  // namespace

int posesFor(std::size_t items, Rotate rotate) {
  if (rotate == Rotate::None) return 1;
  return rotate == Rotate::Quarter ? 4 : effortFor(items).poses;
}

PlaceStrategy largestFirst(const std::vector<PackItem>& items) {
  std::vector<std::uint32_t> all(items.empty() ? 0 : items[0].poses.size());
  std::iota(all.begin(), all.end(), 0u);
  return {ordered(items, Key::Box, 0), std::move(all), 0, {}};
}

std::vector<PlaceStrategy> strategiesFor(const std::vector<PackItem>& items, double tidiness) {
  const Effort effort = effortFor(items.size());
  std::vector<PlaceStrategy> out;
  for (std::size_t k = 0; k < effort.strategies; ++k) {
    // Every second one has more angles; once all keys have had their turn, the order is slightly
    // shuffled.
    const int angles = k % 2 == 0 ? effort.angles : k % 4 == 1 ? effort.poses : 8;
    PlaceStrategy next{ordered(items, kKeys[k % 3], static_cast<unsigned>(k / 3)),
                       turnsOf(items, angles, tidiness > 0),
                       tidiness,
                       {}};
    const bool isNew = std::none_of(out.begin(), out.end(), [&next](const PlaceStrategy& other) {
      return other.turns == next.turns && other.order == next.order;
    });
    if (isNew) out.push_back(std::move(next));
  }
  return out;
}

}  // namespace abflat
