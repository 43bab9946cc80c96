#include "mesh/necks.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/ids.h"
#include "exact/orientation.h"
#include "exact/overlap.h"
#include "mesh/clip_ears.h"
#include "mesh/project_polygon.h"
#include "mesh/surroundings.h"
#include "mesh/vec3_sum.h"

namespace abflat {
namespace {

constexpr double kLeastOpening = 0x1p-24;

/// A polygon in space.
class Walk {
 public:
  Walk(const std::vector<double>& positions, const std::vector<std::uint32_t>& places)
      : positions_(positions), places_(places) {
    std::vector<Vec3> points;
    points.reserve(places.size());
    for (const std::uint32_t v : places) points.push_back(edgeVector(positions, places[0], v));
    normal_ = unit(areaVector(points));
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(places_.size()); }
  Vec3 in(std::uint32_t k) const { return arm(k, k == 0 ? size() - 1 : k - 1); }
  Vec3 out(std::uint32_t k) const { return arm(k, k + 1 == size() ? 0 : k + 1); }
  double shorterEdge(std::uint32_t k) const { return std::min(norm(in(k)), norm(out(k))); }

  /// Unit vector along the bisector of the angle on the right of corner k; along its edges if they
  /// are one.
  Vec3 right(std::uint32_t k) const {
    const Vec3 a = unit(in(k)), b = unit(out(k));
    const Vec3 way = unit(cross(normal_, sum(a, b, -1)));
    return norm(way) > 0 ? way : a;
  }

  Vec3 pointOf(std::uint32_t k, const Vec3& move) const {
    const double* from = &positions_[3 * std::size_t{places_[k]}];
    return sum({from[0], from[1], from[2]}, move);
  }

 private:
  Vec3 arm(std::uint32_t from, std::uint32_t to) const {
    return edgeVector(positions_, places_[from], places_[to]);
  }

  const std::vector<double>& positions_;
  const std::vector<std::uint32_t>& places_;
  Vec3 normal_;
};

/// Whether its triangles lie side by side.
bool isSimple(const std::vector<Vec3>& points) {
  std::vector<double> positions;
  for (const Vec3& p : points) positions.insert(positions.end(), p.begin(), p.end());
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  const std::vector<Point2> flat = projectPolygon(positions, order.data(), order.size());
  std::vector<double> triangles;
  for (const auto& t : clipEars(flat, std::vector<std::uint8_t>(flat.size(), 0))) {
    if (orientation(flat[t[0]].data(), flat[t[1]].data(), flat[t[2]].data()) < 0) return false;
    for (const std::uint32_t k : t)
      triangles.insert(triangles.end(), flat[k].begin(), flat[k].end());
  }
  return !findOverlap(triangles);
}

Opening openAll(const std::vector<Surroundings>& necks, const Walk& walk, double opening) {
  Opening out;
  for (const Surroundings& neck : necks) {
    double least = HUGE_VAL;
    for (const std::uint32_t k : neck.corners()) least = std::min(least, walk.shorterEdge(k));
    std::vector<Vec3> ways;
    for (const std::uint32_t k : neck.corners())
      ways.push_back(sum(Vec3{}, walk.right(k), opening * least));
    const std::vector<Vec3> moves = neck.moves(ways);
    std::vector<std::uint32_t> point(moves.size(), kNone);
    for (std::size_t i = 0; i < neck.corners().size(); ++i) {
      const std::uint32_t k = neck.corners()[i], part = neck.right(i);
      if (point[part] == kNone && norm(moves[part]) > 0) {
        point[part] = static_cast<std::uint32_t>(out.points.size());
        out.points.push_back(walk.pointOf(k, moves[part]));
      }
      out.corners.push_back({k, point[part]});
    }
  }
  return out;
}

std::vector<Vec3> opened(const Walk& walk, const Opening& opening) {
  std::vector<Vec3> points;
  for (std::uint32_t k = 0; k < walk.size(); ++k) points.push_back(walk.pointOf(k, {}));
  for (const Opening::Corner& c : opening.corners)
    if (c.point != kNone) points[c.corner] = opening.points[c.point];
  return points;
}

}  // namespace

std::optional<Opening> openNecks(const std::vector<double>& positions,
                                 const std::vector<std::uint32_t>& places,
                                 const std::vector<std::uint8_t>& bounds) {
  std::vector<Surroundings> necks;
  for (Surroundings& there : surroundings(positions, places, bounds)) {
    if (!there.isPlain()) return std::nullopt;
    if (there.hasNeck()) necks.push_back(std::move(there));
  }
  if (necks.empty()) return Opening{};
  const Walk walk(positions, places);
  double opening = kOpening;
  while (opening > kLeastOpening) {
    Opening out = openAll(necks, walk, opening);
    if (isSimple(opened(walk, out))) return out;
    opening /= 4;
  }
  return std::nullopt;
}

Opening openEach(const std::vector<double>& positions, const std::vector<std::uint32_t>& places,
                 const std::vector<std::uint32_t>& corners) {
  const Walk walk(positions, places);
  Opening out;
  for (const std::uint32_t k : corners) {
    out.corners.push_back({k, static_cast<std::uint32_t>(out.points.size())});
    out.points.push_back(
        walk.pointOf(k, sum(Vec3{}, walk.right(k), kOpening * walk.shorterEdge(k))));
  }
  return out;
}

}  // namespace abflat
