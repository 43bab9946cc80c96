#include "mesh/inside_loops.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/point2.h"
#include "base/stable_order.h"
#include "exact/orientation.h"
#include "exact/overlap.h"
#include "mesh/arms.h"
#include "mesh/clip_ears.h"
#include "mesh/corner_table.h"
#include "mesh/project_polygon.h"

namespace abflat {
namespace {

class Tracer {
 public:
  Tracer(std::vector<Point2> points, const std::vector<std::uint32_t>& places)
      : points_(std::move(points)),
        places_(places),
        count_(static_cast<std::uint32_t>(points_.size())),
        leaving_(count_) {
    std::iota(leaving_.begin(), leaving_.end(), 0u);
    std::vector<std::uint32_t> order = stableOrder(
        count_, [&](std::uint32_t a, std::uint32_t b) { return places[a] < places[b]; });
    for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
      while (end < order.size() && places[order[end]] == places[order[i]]) ++end;
      if (end - i > 1) joinAt(&order[i], &order[i] + (end - i));
    }
  }

  std::vector<CornerLoop> loops() const {
    std::vector<CornerLoop> out;
    std::vector<std::uint8_t> isDone(count_, 0);
    for (std::uint32_t start = 0; start < count_; ++start) {
      if (isDone[start]) continue;
      CornerLoop loop;
      for (std::uint32_t k = start; !isDone[k]; k = after(leaving_[k])) {
        isDone[k] = 1;
        loop.push_back(k);
      }
      if (loop.size() >= 3) out.push_back(std::move(loop));
    }
    return out;
  }

  /// Removes loops without area; false unless the triangles of all others lie side by side.
  bool settle(std::vector<CornerLoop>& loops) const {
    if (!isClear_) return false;
    std::vector<double> triangles;
    const auto bounds = [&](const CornerLoop& loop) {
      std::vector<Point2> p;
      for (const std::uint32_t k : loop) p.push_back(points_[k]);
      int least = 1, most = 0;
      for (const auto& t : clipEars(p, std::vector<std::uint8_t>(p.size(), 0))) {
        const Point2 &a = p[t[0]], &b = p[t[1]], &c = p[t[2]];
        triangles.insert(triangles.end(), {a[0], a[1], b[0], b[1], c[0], c[1]});
        const int sign = orientation(a.data(), b.data(), c.data());
        least = std::min(least, sign);
        most = std::max(most, sign);
      }
      return std::array<int, 2>{least, most};
    };
    std::vector<CornerLoop> out;
    for (CornerLoop& loop : loops) {
      if (goesBack(loop)) continue;
      const auto [least, most] = bounds(loop);
      if (least < 0) return false;
      if (most > 0) out.push_back(std::move(loop));
    }
    loops = std::move(out);
    return !loops.empty() && !findOverlap(triangles);
  }

 private:
  std::uint32_t after(std::uint32_t k) const { return k + 1 == count_ ? 0 : k + 1; }

  /// Whoever arrives at the place leaves along the first clockwise edge such that the inside lies
  /// in between, matched like brackets.
  void joinAt(const std::uint32_t* begin, const std::uint32_t* end) {
    std::vector<Arm> arms = armsAround(points_, begin, end);
    isClear_ = isClear_ && !arms.empty();
    std::vector<std::uint32_t> open;
    for (std::size_t i = 0; i < 2 * arms.size(); ++i) {
      const Arm& arm = arms[i % arms.size()];
      const bool isFirstRound = i < arms.size();
      if (!arm.isOut && isFirstRound) open.push_back(arm.corner);
      if (!arm.isOut || open.empty() || (!isFirstRound && arm.turn == kNone)) continue;
      leaving_[open.back()] = arm.corner;
      open.pop_back();
      arms[i % arms.size()].turn = kNone;
    }
  }

  /// Whether a loop only follows edges there and back again.
  bool goesBack(const CornerLoop& loop) const {
    std::vector<std::uint32_t> path;
    for (std::size_t i = 0; i <= loop.size(); ++i) {
      const std::uint32_t place = places_[loop[i < loop.size() ? i : 0]];
      if (path.size() >= 2 && path[path.size() - 2] == place)
        path.pop_back();
      else
        path.push_back(place);
    }
    return path.size() == 1;
  }

  std::vector<Point2> points_;
  const std::vector<std::uint32_t>& places_;
  std::uint32_t count_;
  std::vector<std::uint32_t> leaving_;  ///< per arriving corner: the corner it leaves from
  bool isClear_ = true;                 ///< no neighbour of a place coincides with it in the plane
};

}  // namespace

Inside insideLoops(const std::vector<double>& positions, const std::vector<std::uint32_t>& places) {
  const Tracer tracer(projectPolygon(positions, places.data(), places.size()), places);
  Inside out;
  out.loops = tracer.loops();
  if (!tracer.settle(out.loops)) return {};
  return out;
}

}  // namespace abflat
