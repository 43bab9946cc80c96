#include "alike/part_match.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/stable_order.h"

namespace abflat {
namespace {

Vec3 fromCentre(const Cells& cells, const PartShape& shape, PolygonCorner c) {
  Vec3 out;
  for (std::size_t d = 0; d < 3; ++d) out[d] = cells.at(c)[d] - shape.centre[d];
  return out;
}

double distanceOf(const Vec3& a, const Vec3& b) { return distanceBetween(a.data(), b.data()); }

Vec3 scaled(Vec3 v, double by) {
  for (double& x : v) x *= by;
  return v;
}

/// Three perpendicular directions in which a part is measured.
struct Frame {
  Vec3 x, y, z;

  /// `a` and `b` are not parallel.
  Frame(const Vec3& a, const Vec3& b, bool isMirrored) {
    x = scaled(a, 1 / norm(a));
    const Vec3 n = cross(a, b);
    z = scaled(n, (isMirrored ? -1 : 1) / norm(n));
    y = cross(scaled(n, 1 / norm(n)), x);
  }
  Vec3 in(const Vec3& p) const { return {dot(p, x), dot(p, y), dot(p, z)}; }
};

/// A corner, and what corners of other parts that correspond to it share with it.
struct Candidate {
  std::uint64_t color;
  double distance;
  PolygonCorner corner;
};

/// The corners of a part by color, then by distance from the centre.
std::vector<Candidate> candidatesOf(const Cells& cells, const PartShapes& shapes, PartId part) {
  std::vector<Candidate> out;
  for (const PolygonFace f : shapes.facesOf(part))
    for (const PolygonCorner c : cells.corners(f))
      out.push_back({shapes.colorAt(f, c), norm(fromCentre(cells, shapes.part[part], c)), c});
  sortStably(out, [](const Candidate& a, const Candidate& b) {
    return a.color != b.color ? a.color < b.color : a.distance < b.distance;
  });
  return out;
}

/// The smallest run of candidates of one color without a larger gap between their distances; of
/// several the farthest from the centre.
IdSpan<std::size_t, Candidate> fewestAlike(const std::vector<Candidate>& all, double gap) {
  std::size_t best = 0, count = all.size() + 1;
  for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
    for (end = i + 1; end < all.size() && all[end].color == all[i].color &&
                      all[end].distance - all[end - 1].distance <= gap;)
      ++end;
    const bool isFarther = end - i == count && all[i].distance > all[best].distance + gap;
    if (end - i >= count && !isFarther) continue;
    best = i;
    count = end - i;
  }
  return {all.data() + best, count};
}

}  // namespace

PartSeed seedOf(const Cells& cells, const PartShapes& shapes, PartId part) {
  const PartShape& shape = shapes.part[part];
  const std::vector<Candidate> all = candidatesOf(cells, shapes, part);
  const IdSpan<std::size_t, Candidate> fewest =
      fewestAlike(all, 2 * kAlikeTolerance * shape.radius);
  const auto at = [&](const Candidate& c) {
    return dot(fromCentre(cells, shape, c.corner), kNoAxis);
  };
  const Candidate& seed =
      *std::max_element(fewest.begin(), fewest.end(),
                        [&](const Candidate& a, const Candidate& b) { return at(a) < at(b); });
  return {seed.corner, seed.color, fewest.front().distance, fewest.back().distance};
}

bool PartMatcher::match(PartId model, const PartSeed& seed, PartId part, bool isMirrored) {
  constexpr std::size_t kMostWalks = 64;
  model_ = model;
  part_ = part;
  isMirrored_ = isMirrored;
  tolerance_ = kAlikeTolerance * shapes_.part[model].radius;
  std::size_t walked = 0;
  for (const PolygonCorner c : candidates(model, seed, part, isMirrored)) {
    if (walked > kMostWalks * shapes_.part[part].faces) break;
    const bool isFound = walk(c, seed.corner) && isCongruent();
    walked += walked_.size();
    for (const PolygonFace m : taken_) isTaken_[m] = 0;
    taken_.clear();
    if (isFound) return true;
    forget();
  }
  return false;
}

/// The part's corners that may correspond to the seed, those first that turn the part least.
std::vector<PolygonCorner> PartMatcher::candidates(PartId model, const PartSeed& seed, PartId part,
                                                   bool isMirrored) const {
  const PartShape &own = shapes_.part[part], &other = shapes_.part[model];
  const Vec3 at = fromCentre(cells_, other, seed.corner);
  const Vec3 next = fromCentre(cells_, other, cells_.next(seed.corner));
  std::vector<std::pair<double, PolygonCorner>> found;
  for (const PolygonFace f : shapes_.facesOf(part)) {
    for (const PolygonCorner c : cells_.corners(f)) {
      if (shapes_.colorAt(f, c) != seed.color) continue;
      const Vec3 p = fromCentre(cells_, own, c);
      const double distance = norm(p);
      if (distance < seed.low - 2 * tolerance_ || distance > seed.high + 2 * tolerance_) continue;
      const PolygonCorner after = isMirrored ? cells_.prev(c) : cells_.next(c);
      const double turn = distanceOf(p, at) + distanceOf(fromCentre(cells_, own, after), next);
      found.emplace_back(turn, c);
    }
  }
  sortStably(found, [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<PolygonCorner> out;
  out.reserve(found.size());
  for (const auto& [turn, c] : found) out.push_back(c);
  return out;
}

/// Walks from polygon to polygon on both parts alike, as long as they are the same.
bool PartMatcher::walk(PolygonCorner from, PolygonCorner to) {
  walked_.clear();
  if (!pairFaces(from, to)) return false;
  for (std::size_t i = 0; i < walked_.size(); ++i)
    for (const PolygonCorner c : cells_.corners(walked_[i])) {
      const PolygonCorner o = cells_.twin[c];
      if (!o.exists()) continue;
      const PolygonCorner m = image_[c];
      const PolygonCorner across =
          isMirrored_ ? cells_.next(cells_.twin[cells_.prev(m)]) : cells_.twin[m];
      if (image_[o].exists() ? image_[o] != across : !pairFaces(o, across)) return false;
    }
  return walked_.size() == shapes_.part[part_].faces;
}

bool PartMatcher::pairFaces(PolygonCorner from, PolygonCorner to) {
  const PolygonFace f = cells_.face[from], m = cells_.face[to];
  if (cells_.size(f) != cells_.size(m) || shapes_.color[f] != shapes_.color[m] || isTaken_[m])
    return false;
  walked_.push_back(f);
  isTaken_[m] = 1;
  taken_.push_back(m);
  for (std::uint32_t k = cells_.size(f); k > 0; --k) {
    image_[from] = to;
    if (!isSameEdge(from, to)) return false;
    from = cells_.next(from);
    to = isMirrored_ ? cells_.prev(to) : cells_.next(to);
  }
  return true;
}

/// Whether the edges that leave the two corners are the same, as far as can be seen there.
bool PartMatcher::isSameEdge(PolygonCorner from, PolygonCorner to) const {
  const PolygonCorner edge = isMirrored_ ? cells_.prev(to) : to;
  if (cells_.edgeMark[from] != cells_.edgeMark[edge] ||
      cells_.twin[from].exists() != cells_.twin[edge].exists())
    return false;
  const double length = distanceBetween(cells_.at(from), cells_.at(cells_.next(from)));
  const double other = distanceBetween(cells_.at(edge), cells_.at(cells_.next(edge)));
  const double distance = norm(fromCentre(cells_, shapes_.part[part_], from));
  const double otherDistance = norm(fromCentre(cells_, shapes_.part[model_], to));
  return std::abs(length - other) <= 2 * tolerance_ &&
         std::abs(distance - otherDistance) <= 2 * tolerance_;
}

/// Whether one motion takes every corner to within the tolerance of its own. The motion is that of
/// two corners far from the centre and from each other.
bool PartMatcher::isCongruent() const {
  const PolygonCorner a = farthest([](const Vec3& p) { return dot(p, p); });
  if (!a.exists()) return false;
  const Vec3 along = onModel(a), ownAlong = onPart(a);
  const PolygonCorner b = farthest([&](const Vec3& p) {
    const Vec3 n = cross(along, p);
    return dot(n, n);
  });
  if (!b.exists()) return false;
  const Vec3 aside = onModel(b), ownAside = onPart(b);
  const auto isFlat = [&](const Vec3& p, const Vec3& q) {
    return !(norm(cross(p, q)) > tolerance_ * norm(p));
  };
  if (isFlat(along, aside) || isFlat(ownAlong, ownAside)) return false;
  const Frame own(ownAlong, ownAside, isMirrored_), model(along, aside, false);
  for (const PolygonFace f : walked_)
    for (const PolygonCorner c : cells_.corners(f))
      if (distanceOf(own.in(onPart(c)), model.in(onModel(c))) > tolerance_) return false;
  return true;
}

Vec3 PartMatcher::onPart(PolygonCorner c) const {
  return fromCentre(cells_, shapes_.part[part_], c);
}
Vec3 PartMatcher::onModel(PolygonCorner c) const {
  return fromCentre(cells_, shapes_.part[model_], image_[c]);
}

/// The corner of the part whose image has the largest value; none if all are 0.
template <class Value>
PolygonCorner PartMatcher::farthest(const Value& value) const {
  std::pair<double, PolygonCorner> best{0, PolygonCorner()};
  for (const PolygonFace f : walked_)
    for (const PolygonCorner c : cells_.corners(f))
      if (const double x = value(onModel(c)); x > best.first) best = {x, c};
  return best.second;
}

void PartMatcher::forget() {
  for (const PolygonFace f : walked_)
    for (const PolygonCorner c : cells_.corners(f)) image_[c] = PolygonCorner();
  walked_.clear();
}

}  // namespace abflat
