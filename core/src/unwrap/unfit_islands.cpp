#include "unwrap/unfit_islands.h"

#include <algorithm>
#include <cmath>

#include "base/stable_order.h"
#include "exact/orientation.h"
#include "exact/overlap.h"
#include "mesh/triangle_geometry.h"
#include "seam/given_seams.h"

namespace abflat {
namespace {

/// A connected set of fixed triangles.
struct Island {
  std::vector<SurfaceTriangle> triangles;
  bool isChart = false;  ///< of an earlier run
  double area = 0;       ///< in uv
  std::string trouble;   ///< why it cannot stay, naming a face; empty: it can
};

class UnfitIslands {
 public:
  UnfitIslands(const SurfaceMap& map, bool hasTiles, FixedTriangles& fixed)
      : map_(map), hasTiles_(hasTiles), fixed_(fixed) {}

  std::string free() {
    collect();
    for (Island& island : islands_)
      if (!island.isChart) judge(island);
    judgeOverlaps();
    for (const Island& island : islands_)
      for (const SurfaceTriangle t : island.triangles) fixed_.isFixed[t] = island.trouble.empty();
    return note();
  }

 private:
  std::uint32_t texcoordOf(SurfaceCorner c) const { return fixed_.ofCorner[map_.corner(c)]; }
  const double* at(SurfaceTriangle t, std::size_t k) const {
    return &fixed_.texcoords[2 * std::size_t{texcoordOf(cornerOf(t, k))}];
  }

  void collect() {
    IdVector<SurfaceTriangle, std::uint8_t> isTaken(fixed_.isFixed.size(), 0);
    for (const SurfaceTriangle first : fixed_.isFixed.ids()) {
      if (!fixed_.isFixed[first] || isTaken[first]) continue;
      Island island;
      const std::uint32_t texcoord = texcoordOf(cornerOf(first, 0));
      island.isChart =
          texcoord != kNoTexcoord && 2 * texcoord >= map_.input().extras().texcoords.size();
      island.triangles.push_back(first);
      isTaken[first] = 1;
      for (std::size_t i = 0; i < island.triangles.size(); ++i)
        for (const SurfaceCorner h : cornersOf(island.triangles[i])) {
          const SurfaceCorner twin = map_.surface().table.twin[h];
          if (!twin.exists() || !fixed_.isFixed[triangleOf(twin)] || isTaken[triangleOf(twin)] ||
              !hasSameTexcoords({fixed_.texcoords, fixed_.ofCorner}, map_, h))
            continue;
          isTaken[triangleOf(twin)] = 1;
          island.triangles.push_back(triangleOf(twin));
        }
      islands_.push_back(std::move(island));
    }
  }

  /// Looks for trouble of the island on its own, besides overlaps.
  void judge(Island& island) const {
    for (const SurfaceTriangle t : island.triangles)
      for (const SurfaceCorner c : cornersOf(t))
        if (texcoordOf(c) == kNoTexcoord) return blame(island, t, "has no texcoord at a corner");
    Point2 low = {HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL};
    for (const SurfaceTriangle t : island.triangles) {
      const int sign = orientation(at(t, 0), at(t, 1), at(t, 2));
      if (sign < 0) return blame(island, t, "is mirrored");
      if (sign == 0 && hasArea(t)) return blame(island, t, "is degenerate");
      island.area += areaOf(t);
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t d = 0; d < 2; ++d) {
          low[d] = std::min(low[d], at(t, k)[d]);
          high[d] = std::max(high[d], at(t, k)[d]);
        }
    }
    const Point2 tile = tileAround(low, high, hasTiles_);
    for (const SurfaceTriangle t : island.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t d = 0; d < 2; ++d)
          if (!(at(t, k)[d] >= tile[d] && at(t, k)[d] <= tile[d] + 1))
            return blame(island, t, hasTiles_ ? "leaves its tile" : "leaves the unit square");
  }

  void blame(Island& island, SurfaceTriangle t, const std::string& why) const {
    island.trouble = nameOf(map_.face(t)) + " " + why;
  }

  bool hasArea(SurfaceTriangle t) const {
    std::vector<double> points;
    for (const SurfaceCorner c : cornersOf(t))
      for (const double x : map_.input().position(map_.vertex(c))) points.push_back(x);
    return !isDegenerate(points, {0, 1, 2});
  }

  double areaOf(SurfaceTriangle t) const {
    const double *a = at(t, 0), *b = at(t, 1), *c = at(t, 2);
    return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
  }

  void judgeOverlaps() {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < islands_.size(); ++i)
      if (islands_[i].trouble.empty()) order.push_back(i);
    sortStably(order, [&](std::size_t i, std::size_t j) {
      const Island &a = islands_[i], &b = islands_[j];
      return a.isChart != b.isChart ? a.isChart : a.area > b.area;
    });
    std::vector<double> uv;
    std::vector<std::uint32_t> group;
    for (std::size_t i = 0; i < order.size(); ++i)
      for (const SurfaceTriangle t : islands_[order[i]].triangles) {
        for (std::size_t k = 0; k < 3; ++k) uv.insert(uv.end(), at(t, k), at(t, k) + 2);
        group.push_back(static_cast<std::uint32_t>(i));
      }
    const std::vector<std::uint32_t> other = leaveOutOverlaps(uv, group, order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      Island& island = islands_[order[i]];
      if (other[i] == kNoOverlap || island.isChart) continue;
      const SurfaceTriangle there = islands_[order[other[i]]].triangles.front();
      const std::string what = other[i] == i ? "itself" : "that of " + nameOf(map_.face(there));
      island.trouble =
          "the island of " + nameOf(map_.face(island.triangles.front())) + " overlaps " + what;
    }
  }

  std::string note() const {
    constexpr std::size_t kNamed = 3;
    std::size_t all = 0, freed = 0;
    std::string named;
    for (const Island& island : islands_) {
      all += !island.isChart;
      if (island.trouble.empty()) continue;
      if (freed < kNamed) named += (freed > 0 ? ", " : "") + island.trouble;
      ++freed;
    }
    if (freed == 0) return {};
    if (freed > kNamed) named += " and " + std::to_string(freed - kNamed) + " more";
    return "kept " + std::to_string(all - freed) + " of " + std::to_string(all) +
           " UV islands and unwrapped the others: " + named;
  }

  const SurfaceMap& map_;
  const bool hasTiles_;
  FixedTriangles& fixed_;
  std::vector<Island> islands_;
};

}  // namespace

Point2 tileAround(const Point2& low, const Point2& high, bool hasTiles) {
  constexpr double kLastColumn = 9, kLastRow = 898;  // of UDIM
  Point2 tile = {0, 0};
  for (std::size_t d = 0; d < 2 && hasTiles; ++d)
    tile[d] = std::clamp(std::floor((low[d] + high[d]) / 2), 0.0, d == 0 ? kLastColumn : kLastRow);
  return tile;
}

std::string freeUnfitIslands(const SurfaceMap& map, bool hasTiles, FixedTriangles& fixed) {
  return UnfitIslands(map, hasTiles, fixed).free();
}

}  // namespace abflat
