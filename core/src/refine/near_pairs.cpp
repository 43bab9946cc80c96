#include "refine/near_pairs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// A grid whose squares know the edges near them, so that a point finds its edges in its own
/// square.
class EdgeGrid {
 public:
  EdgeGrid(const std::vector<double>& points, double reach,
           const std::vector<std::uint8_t>& isAsked)
      : points_(points), reach_(reach) {
    const std::uint32_t n = count();
    double length = 0;
    low_[0] = low_[1] = HUGE_VAL;
    for (std::uint32_t i = 0; i < n; ++i) {
      length += norm(at(i + 1, 0) - at(i, 0), at(i + 1, 1) - at(i, 1));
      for (std::size_t d = 0; d < 2; ++d) low_[d] = std::min(low_[d], at(i, d));
    }
    side_ = std::max(2 * reach, length / n);
    for (std::uint32_t i = 0; i < n; ++i)
      if (isAsked.empty() || isAsked[i]) addEdge(i);
    std::sort(edges_.begin(), edges_.end());
  }

  std::uint32_t count() const { return static_cast<std::uint32_t>(points_.size() / 2); }
  double at(std::uint32_t i, std::size_t d) const {
    return points_[2 * (i == count() ? 0 : i) + d];
  }

  /// Calls use(edge), in order.
  template <class Use>
  void forEdgesNear(std::uint32_t point, const Use& use) const {
    const std::uint64_t key = keyOf(cell(at(point, 0), 0), cell(at(point, 1), 1));
    auto e = std::lower_bound(edges_.begin(), edges_.end(), std::make_pair(key, 0u));
    for (; e != edges_.end() && e->first == key; ++e) use(e->second);
  }

 private:
  std::int64_t cell(double x, std::size_t d) const {
    return static_cast<std::int64_t>(std::floor((x - low_[d]) / side_)) + 1;
  }
  static std::uint64_t keyOf(std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) << 32 | static_cast<std::uint64_t>(y);
  }

  /// Column by column.
  void addEdge(std::uint32_t i) {
    double ax = at(i, 0), ay = at(i, 1), bx = at(i + 1, 0), by = at(i + 1, 1);
    if (ax > bx) {
      std::swap(ax, bx);
      std::swap(ay, by);
    }
    const std::int64_t last = cell(bx + reach_, 0);
    for (std::int64_t x = cell(ax - reach_, 0); x <= last; ++x) {
      const double left = low_[0] + static_cast<double>(x - 1) * side_ - reach_;
      const double right = left + side_ + 2 * reach_;
      const double from = heightAt(left, ax, ay, bx, by), to = heightAt(right, ax, ay, bx, by);
      const std::int64_t top = cell(std::max(from, to) + reach_, 1);
      for (std::int64_t y = cell(std::min(from, to) - reach_, 1); y <= top; ++y)
        edges_.emplace_back(keyOf(x, y), i);
    }
  }

  static double heightAt(double x, double ax, double ay, double bx, double by) {
    if (x <= ax) return ay;
    if (x >= bx) return by;
    return ay + (by - ay) * ((x - ax) / (bx - ax));
  }

  const std::vector<double>& points_;
  double reach_, side_ = 0, low_[2];
  std::vector<std::pair<std::uint64_t, std::uint32_t>> edges_;
};

}  // namespace

std::vector<NearPair> findNearPairs(const std::vector<double>& points, double reach) {
  std::vector<NearPair> out;
  forNearPairs(points, reach, {}, [&](const NearPair& pair) { out.push_back(pair); });
  return out;
}

void forNearPairs(const std::vector<double>& points, double reach,
                  const std::vector<std::uint8_t>& isAsked,
                  const std::function<void(const NearPair&)>& use) {
  const EdgeGrid grid(points, reach, isAsked);
  const std::uint32_t n = grid.count();
  for (std::uint32_t p = 0; p < n; ++p) {
    if (!isAsked.empty() && !isAsked[p]) continue;
    grid.forEdgesNear(p, [&](std::uint32_t e) {
      if (e != p && (e + 1) % n != p) use({p, e});
    });
  }
}

}  // namespace abflat
