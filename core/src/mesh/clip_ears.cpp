#include "mesh/clip_ears.h"

#include <cmath>
#include <queue>
#include <utility>

#include "base/few_bits.h"
#include "mesh/point_tree.h"

namespace abflat {
namespace {

double squaredDistance(const Point2& a, const Point2& b) {
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

/// Cuts off the roundest ear first. The quality of a corner changes only when one of its neighbours
/// goes: an ear that contains a corner contains a reflex one, which is not the next to go.
class EarClipper {
 public:
  EarClipper(std::vector<Point2> points, const std::vector<std::uint8_t>& keep,
             const Listener& listener)
      : points_(std::move(points)),
        keep_(keep),
        listener_(listener),
        n_(static_cast<std::uint32_t>(points_.size())),
        next_(n_),
        previous_(n_),
        turn_(n_, 0),
        mayBlock_(n_, 0),
        blockers_(points_) {
    for (std::uint32_t k = 0; k < n_; ++k) {
      next_[k] = k + 1 == n_ ? 0 : k + 1;
      previous_[k] = k == 0 ? n_ - 1 : k - 1;
    }
    for (std::uint32_t k = 0; k < n_; ++k) noteReflex(k);
    for (std::uint32_t k = 0; k < n_ && listener_.beat(kSteps); ++k) ears_.push({quality(k), k, 0});
  }

  /// The triangles, as local corner indices.
  std::vector<std::array<std::uint32_t, 3>> run() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::uint32_t some = 0;
    for (std::uint32_t left = n_; left > 3; --left) {
      if (!listener_.beat(kSteps)) return triangles;
      const std::uint32_t ear = left > 4 ? takeBest() : lastOf(takeBest());
      const std::uint32_t before = previous_[ear], after = next_[ear];
      triangles.push_back({before, ear, after});
      next_[before] = after;
      previous_[after] = before;
      turn_[ear] = kGone;
      if (mayBlock_[ear]) blockers_.remove(ear);
      for (const std::uint32_t k : {before, after}) {
        noteReflex(k);
        ears_.push({quality(k), k, ++turn_[k]});
      }
      some = after;
    }
    while (previous_[some] < some) some = previous_[some];
    triangles.push_back({some, next_[some], previous_[some]});
    return triangles;
  }

 private:
  static constexpr std::uint32_t kGone = 0xffffffffu;
  static constexpr std::size_t kSteps = 16;  ///< number of quality steps of a corner

  struct Ear {
    double quality;
    std::uint32_t corner;
    std::uint32_t turn;  ///< how often the corner had been judged before

    /// Among equal ears the one with the smaller index is better.
    bool operator<(const Ear& other) const {
      return quality != other.quality ? quality < other.quality : corner > other.corner;
    }
  };

  std::uint32_t takeBest() {
    while (ears_.top().turn != turn_[ears_.top().corner]) ears_.pop();
    const std::uint32_t corner = ears_.top().corner;
    ears_.pop();
    return corner;
  }

  /// The ear, or its neighbour where that keeps more: of four corners, the one opposite the ear
  /// becomes an ear, too.
  std::uint32_t lastOf(std::uint32_t ear) const {
    const auto keepsAll = [&](std::uint32_t k) { return !keep_[k] && !keep_[next_[next_[k]]]; };
    const std::uint32_t other = next_[ear];
    return !keepsAll(ear) && keepsAll(other) && quality(other) > 0 ? other : ear;
  }

  void noteReflex(std::uint32_t k) {
    if (mayBlock_[k] || turnOf(points_[previous_[k]], points_[k], points_[next_[k]]) > 0) return;
    mayBlock_[k] = 1;
    blockers_.add(k);
  }

  /// In (0, 1] for a proper ear, larger is rounder; below 0 if the ear is reflex, flat or not
  /// empty.
  double quality(std::uint32_t k) const {
    const Point2 &a = points_[previous_[k]], &b = points_[k], &c = points_[next_[k]];
    const double edges = squaredDistance(a, b) + squaredDistance(b, c) + squaredDistance(c, a);
    double q = edges > 0 ? turnOf(a, b, c) * 2 * std::sqrt(3.0) / edges : 0;
    if (!(q > 0)) return q < 0 ? q - 2 : -2;
    q = inFewBits(q);
    if (blockers_.hasIn(a, b, c)) q -= 2;
    if (keep_[k]) q -= 1;
    return q;
  }

  std::vector<Point2> points_;
  const std::vector<std::uint8_t>& keep_;  ///< corners that should not become ears
  const Listener& listener_;
  std::uint32_t n_;
  std::vector<std::uint32_t> next_, previous_;  ///< around the remaining polygon
  std::vector<std::uint32_t> turn_;             ///< of each corner's valid entry in ears_, or kGone
  std::vector<std::uint8_t> mayBlock_;
  PointTree blockers_;  ///< remaining corners that are reflex or flat, or once were
  std::priority_queue<Ear> ears_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> clipEars(std::vector<Point2> points,
                                                   const std::vector<std::uint8_t>& keep,
                                                   const Listener& listener) {
  return EarClipper(std::move(points), keep, listener).run();
}

}  // namespace abflat
