#include "mesh/straight_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.h"
#include "base/portable_math.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

constexpr double kMostBend = 80 * kPi / 180;         // right angles stay cut
constexpr double kMostBendOfStep = 100 * kPi / 180;  // where edges are fine
constexpr double kSameBend = 1e-6;                   // radians; far above rounding
constexpr std::size_t kMostFaces = 4;                // that traverse an edge in one direction

/// A half-edge at the edge, and where its triangle lies: a unit vector at right angles to the edge.
struct Leaf {
  SurfaceCorner h;
  Vec3 direction;
  bool ends = false;  ///< whether its surface does within a few triangles
};

/// 0 if they continue each other, pi if they are folded onto each other.
double bend(const Leaf& a, const Leaf& b) {
  return portable::atan2(norm(cross(a.direction, b.direction)), -dot(a.direction, b.direction));
}

/// The best way to join the leaves on one side of an edge to those on the other: the one with the
/// most pairs, weighed against their bends.
class Matching {
 public:
  Matching(const std::vector<Leaf>& forward, const std::vector<Leaf>& backward)
      : forward_(forward), backward_(backward) {
    isTaken_.fill(false);
    chosen_.fill(kNone);
    best_ = chosen_;
    tryFrom(0, 0);
  }

  bool isClear() const { return second_ - value_ > kSameBend; }
  /// Index of the leaf behind that is joined to one ahead, or kNone.
  std::uint32_t partner(std::size_t i) const { return best_[i]; }

 private:
  /// Each pair is worth what it falls short of the largest bend; values are negative, small is
  /// best.
  void tryFrom(std::size_t i, double value) {
    if (i == forward_.size()) {
      if (value < value_) {
        second_ = value_;
        value_ = value;
        best_ = chosen_;
      } else {
        second_ = std::min(second_, value);
      }
      return;
    }
    tryFrom(i + 1, value);
    for (std::uint32_t j = 0; j < backward_.size(); ++j) {
      const double gain = isTaken_[j] ? 0 : kMostBend - bend(forward_[i], backward_[j]);
      if (gain <= 0) continue;
      isTaken_[j] = true;
      chosen_[i] = j;
      tryFrom(i + 1, value - gain);
      chosen_[i] = kNone;
      isTaken_[j] = false;
    }
  }

  const std::vector<Leaf>&forward_, &backward_;
  std::array<bool, kMostFaces> isTaken_;
  std::array<std::uint32_t, kMostFaces> chosen_, best_;
  double value_ = HUGE_VAL, second_ = HUGE_VAL;
};

/// False if the triangle has no area to tell.
bool seeDirection(const std::vector<double>& positions, const CornerTable& table, Leaf& leaf) {
  std::array<Vec3, 3> e;
  if (!unitEdges(positions, verticesOf(table.vertex, triangleOf(leaf.h)), e)) return false;
  const std::size_t k = placeInTriangle(leaf.h);
  const Vec3 &edge = e[k], &back = e[(k + 2) % 3];
  const double along = dot(edge, back);
  for (std::size_t d = 0; d < 3; ++d) leaf.direction[d] = along * edge[d] - back[d];
  const double length = norm(leaf.direction);
  if (length < kDegenerateAngle) return false;
  for (double& x : leaf.direction) x /= length;
  return true;
}

/// Where more than two faces meet.
IdVector<SurfaceCorner, std::uint8_t> cornersThere(const CornerTable& table) {
  IdVector<SurfaceCorner, std::uint8_t> out(table.vertex.size(), 0);
  for (const SurfaceCorner h : table.nonManifoldCorners) out[h] = 1;
  return out;
}

/// Whether the surface around a triangle has a border within a few triangles. `isCut`: at
/// half-edges that are no border, although they have no twins.
bool endsNear(const CornerTable& table, const IdVector<SurfaceCorner, std::uint8_t>& isCut,
              SurfaceTriangle first) {
  constexpr int kSteps = 3;
  std::array<SurfaceTriangle, 1 + 3 + 6 + 12> found;
  found[0] = first;
  auto end = found.begin() + 1;
  auto next = found.begin();
  for (int step = 0; step <= kSteps; ++step)
    for (const auto last = end; next != last; ++next)
      for (const SurfaceCorner h : cornersOf(*next)) {
        const SurfaceCorner twin = table.twin[h];
        if (!twin.exists() && !isCut[h]) return true;
        if (!twin.exists() || step == kSteps) continue;
        const SurfaceTriangle beyond = triangleOf(twin);
        if (std::find(found.begin(), end, beyond) == end) *end++ = beyond;
      }
  return false;
}

void joinLeaves(const Leaf& a, const Leaf& b, BadEdge& edge, CornerTable& table) {
  table.twin[a.h] = b.h;
  table.twin[b.h] = a.h;
  ++edge.pairs;
}

/// The only leaf whose surface does not end soon; the end of the list if there are none or several.
std::vector<Leaf>::iterator onlyGoingOn(std::vector<Leaf>& leaves) {
  const auto goesOn = [](const Leaf& leaf) { return !leaf.ends; };
  const auto first = std::find_if(leaves.begin(), leaves.end(), goesOn);
  if (first == leaves.end()) return first;
  return std::find_if(first + 1, leaves.end(), goesOn) == leaves.end() ? first : leaves.end();
}

/// Joins the only two leaves whose surfaces do not end soon.
void joinGoingOn(std::vector<Leaf>& forward, std::vector<Leaf>& backward, BadEdge& edge,
                 CornerTable& table) {
  const auto a = onlyGoingOn(forward), b = onlyGoingOn(backward);
  if (a == forward.end() || b == backward.end() || bend(*a, *b) > kMostBendOfStep) return;
  joinLeaves(*a, *b, edge, table);
  forward.erase(a);
  backward.erase(b);
}

}  // namespace

void joinStraightPairs(const std::vector<double>& positions, double fine, CornerTable& table) {
  if (table.nonManifold.empty()) return;
  const IdVector<SurfaceCorner, std::uint8_t> isCut = cornersThere(table);
  std::vector<std::uint8_t> ends;  // before any are joined
  ends.reserve(table.nonManifoldCorners.size());
  for (const SurfaceCorner h : table.nonManifoldCorners)
    ends.push_back(fine > 0 && endsNear(table, isCut, triangleOf(h)));
  std::vector<Leaf> forward, backward;
  std::size_t begin = 0;
  for (BadEdge& edge : table.nonManifold) {
    forward.clear();
    backward.clear();
    for (std::size_t i = begin; i < begin + edge.faceCount; ++i) {
      Leaf leaf{table.nonManifoldCorners[i], {}, ends[i] != 0};
      if (seeDirection(positions, table, leaf))
        (table.vertex[leaf.h] == edge.v0 ? forward : backward).push_back(leaf);
    }
    begin += edge.faceCount;
    if (norm(edgeVector(positions, edge.v0, edge.v1)) < fine)
      joinGoingOn(forward, backward, edge, table);
    if (std::max(forward.size(), backward.size()) > kMostFaces) continue;
    const Matching matching(forward, backward);
    if (!matching.isClear()) continue;
    for (std::size_t i = 0; i < forward.size(); ++i)
      if (const std::uint32_t j = matching.partner(i); j != kNone)
        joinLeaves(forward[i], backward[j], edge, table);
  }
}

}  // namespace abflat
