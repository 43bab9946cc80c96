#include "pack/outline_chords.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pack/pose.h"

namespace abflat {
namespace {

/// Shares, and lengths relative to each other, are alike up to this much, so that rounding decides
/// nothing.
constexpr double kSameChord = 1e-9;

double cross(PlanePoint a, PlanePoint b) { return a.x * b.y - a.y * b.x; }

/// 1 if it turns left, -1 if right, 0 if it hardly turns.
int turn(PlanePoint a, PlanePoint b, PlanePoint c) {
  const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
  const double straight = kSameChord * distance(a, b) * distance(a, c);
  return left - right > straight ? 1 : left - right < -straight ? -1 : 0;
}

/// Whether x, on the line through a and b, lies between them.
bool isBetween(PlanePoint a, PlanePoint b, PlanePoint x) {
  return (a.x - x.x) * (b.x - x.x) + (a.y - x.y) * (b.y - x.y) <= 0;
}

bool doCross(PlanePoint a, PlanePoint b, PlanePoint c, PlanePoint d) {
  const int left = turn(a, b, c), right = turn(a, b, d);
  // Edges ahead on the same line, as those of a net next to a crease, are not crossed.
  if (left == 0 && right == 0) return isBetween(a, b, c) || isBetween(a, b, d);
  return left * right <= 0 && turn(c, d, a) * turn(c, d, b) <= 0;
}

/// Whether the direction to `to` lies in the interior wedge between the two edges at a point.
bool beginsInside(const std::vector<PlanePoint>& p, std::size_t i, PlanePoint to) {
  const PlanePoint before = p[(i + p.size() - 1) % p.size()], after = p[(i + 1) % p.size()];
  const bool isLeftOfBefore = turn(before, p[i], to) > 0, isLeftOfAfter = turn(p[i], after, to) > 0;
  return turn(before, p[i], after) > 0 ? isLeftOfBefore && isLeftOfAfter
                                       : isLeftOfBefore || isLeftOfAfter;
}

bool isInside(const std::vector<PlanePoint>& p, std::size_t i, std::size_t j) {
  if (!beginsInside(p, i, p[j]) || !beginsInside(p, j, p[i])) return false;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const std::size_t next = (k + 1) % p.size();
    if (k == i || k == j || next == i || next == j) continue;
    if (doCross(p[i], p[j], p[k], p[next])) return false;
  }
  return true;
}

/// Kinds of similar cuts: by the share they cut off, at which end, and across or along the box.
constexpr std::size_t kShares = 5, kKinds = 4 * kShares;

std::size_t kindOf(PlanePoint from, PlanePoint to, double share) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  // The way from one point to the other lies to the right, and encloses `share`.
  const bool isRightSmaller = share < 0.5 - kSameChord;
  const bool isAcross = std::abs(dy) * (1 - kSameChord) > std::abs(dx);
  const bool isAtEnd = (isAcross ? dy > 0 : dx < 0) == isRightSmaller;
  const double part = 2 * kShares * (std::min(share, 1 - share) + kSameChord);
  return 4 * std::min(static_cast<std::size_t>(part), kShares - 1) + (isAcross ? 2 : 0) +
         (isAtEnd ? 1 : 0);
}

/// The shorter one, or of two that are alike the one that halves the outline better.
bool isBetter(const OutlineChord& a, const OutlineChord& b) {
  if (a.length < b.length * (1 - kSameChord)) return true;
  return a.length < b.length * (1 + kSameChord) && a.smallerShare() > b.smallerShare() + kSameChord;
}

}  // namespace

std::vector<OutlineChord> outlineChords(const std::vector<PlanePoint>& outline,
                                        const std::vector<std::uint8_t>& mayEnd) {
  constexpr double kLeastShare = 0.03;
  const std::size_t n = outline.size();
  const auto isEnd = [&](std::size_t i) { return mayEnd.empty() || mayEnd[i]; };
  const Pose box = leastBoxPose(convexHull(outline));
  std::vector<PlanePoint> p;
  p.reserve(n);
  for (const PlanePoint& q : outline) p.push_back(box.rotated(q));
  std::vector<double> swept(n + 1, 0);
  for (std::size_t i = 0; i < n; ++i) swept[i + 1] = swept[i] + cross(p[i], p[(i + 1) % n]);
  std::array<OutlineChord, kKinds> best{};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = isEnd(i) ? i + 2 : n; j < n; ++j) {
      if (!isEnd(j)) continue;
      const double share = (swept[j] - swept[i] + cross(p[j], p[i])) / swept[n];
      if (!(std::min(share, 1 - share) > kLeastShare)) continue;
      const double dx = p[j].x - p[i].x, dy = p[j].y - p[i].y;
      const double length = std::sqrt(dx * dx + dy * dy);
      const OutlineChord chord{i, j, length, share};
      OutlineChord& own = best[kindOf(p[i], p[j], share)];
      if ((own.to == 0 || isBetter(chord, own)) && isInside(p, i, j)) own = chord;
    }
  std::vector<OutlineChord> out;
  for (const OutlineChord& chord : best)
    if (chord.to > 0) out.push_back(chord);
  return out;
}

}  // namespace abflat
