#include "layout/grid_repair.h"

#include <algorithm>
#include <cmath>

#include "base/point2.h"
#include "base/portable_math.h"
#include "exact/orientation.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

constexpr int kMostSteps = 12;  ///< less than packing leaves free around a chart
constexpr int kMostRounds = 60;
constexpr double kWantedHeight = 1.5;  ///< of triangles, in steps

class Repair {
 public:
  Repair(const DiskChart& chart, const std::vector<double>& exact, double step,
         std::vector<double>& uv)
      : chart_(chart), step_(step), uv_(uv), from_(uv), corners_(chart.vertexOfCorner) {
    for (const auto& angles : chart.angles) mayBeFlat_.push_back(isDegenerate(angles));
    addTurns(exact);
    first_.assign(chart.vertexCount() + std::size_t{1}, 0);
    for (const ChartVertex v : corners_) ++first_[v + 1];
    for (const ChartVertex v : chart.vertices()) first_[v + 1] += first_[v];
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    triangles_.resize(corners_.size());
    for (const ChartCorner c : corners_.ids()) triangles_[fill[corners_[c]]++] = triangleOf(c);
  }

  GridRepair run() {
    GridRepair out;
    for (int round = 0; round < kMostRounds; ++round) {
      const std::vector<ChartVertex> thin = thinVertices();
      out.isValid = wrong_ == 0;
      if (out.isValid) break;
      // Near places first, so that most vertices stay close.
      const int reach = std::min(1 + round / 4, kMostSteps);
      bool isMoved = false;
      for (const ChartVertex v : thin) isMoved = move(v, reach) || isMoved;
      if (!isMoved && reach == kMostSteps) break;
    }
    for (const ChartVertex v : chart_.vertices()) {
      const Point2 now = pointAt(uv_, v), before = pointAt(from_, v);
      const double by = std::max(std::abs(now[0] - before[0]), std::abs(now[1] - before[1]));
      out.moved += by > 0;
      out.farthest = std::max(out.farthest, by);
    }
    return out;
  }

 private:
  /// Adds triangles outside the boundary wherever it turns clockwise, so that it does not cross
  /// itself.
  void addTurns(const std::vector<double>& exact) {
    const std::size_t n = chart_.boundary.size();
    const auto vertex = [&](std::size_t i) { return chart_.boundaryVertex(BoundaryIndex(i % n)); };
    for (std::size_t i = 0; i < n; ++i) {
      const ChartVertex before = vertex(i), at = vertex(i + 1), after = vertex(i + 2);
      const auto [a, b, c] = pointsOf(exact, {after, at, before});
      if (orientation(a, b, c) <= 0) continue;
      for (const ChartVertex v : {after, at, before}) corners_.push_back(v);
      mayBeFlat_.push_back(0);
    }
  }

  std::array<const double*, 3> pointsAt(ChartTriangle t) const {
    return pointsOf(uv_, verticesOf(corners_, t));
  }

  /// Height of the triangle in steps; negative if it is flipped.
  double height(ChartTriangle t) const {
    const auto [a, b, c] = pointsAt(t);
    const double ux = (b[0] - a[0]) / step_, uy = (b[1] - a[1]) / step_;
    const double vx = (c[0] - a[0]) / step_, vy = (c[1] - a[1]) / step_;
    const double longest = std::max({norm(ux, uy), norm(vx, vy), norm(vx - ux, vy - uy)});
    return longest > 0 ? (ux * vy - uy * vx) / longest : 0;
  }

  /// How far a triangle falls short of its wanted height, squared.
  double lack(ChartTriangle t) const {
    const double wanted = mayBeFlat_[t] ? 0 : kWantedHeight;
    const double missing = std::max(wanted - height(t), 0.0);
    return missing * missing;
  }

  double lackAround(ChartVertex v) const {
    double sum = 0;
    for (std::uint32_t i = first_[v]; i < first_[v + 1]; ++i) sum += lack(triangles_[i]);
    return sum;
  }

  /// Vertices of triangles that are too thin. Also counts the triangles that are wrong.
  std::vector<ChartVertex> thinVertices() {
    std::vector<ChartVertex> out;
    wrong_ = 0;
    for (const ChartTriangle t : mayBeFlat_.ids()) {
      const auto [a, b, c] = pointsAt(t);
      const int sign = orientation(a, b, c);
      wrong_ += sign < 0 || (sign == 0 && !mayBeFlat_[t]);
      if (!(lack(t) > 0)) continue;
      for (const ChartCorner h : cornersOf(t)) out.push_back(corners_[h]);
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  /// Moves a vertex to where its triangles lack the least; the nearest such place on ties.
  bool move(ChartVertex v, int reach) {
    double* p = &uv_[2 * std::size_t{v}];
    const double old[2] = {p[0], p[1]};
    double best[2] = {p[0], p[1]};
    double least = lackAround(v);
    if (!(least > 0)) return false;
    for (int ring = 1; ring <= reach; ++ring)
      for (int x = -ring; x <= ring; ++x)
        for (int y = -ring; y <= ring; y += std::abs(x) == ring ? 1 : 2 * ring) {
          p[0] = old[0] + x * step_;
          p[1] = old[1] + y * step_;
          if (!isNear(v)) continue;
          const double now = lackAround(v);
          if (!(now < least * (1 - 1e-9))) continue;
          least = now;
          best[0] = p[0];
          best[1] = p[1];
        }
    p[0] = best[0];
    p[1] = best[1];
    return p[0] != old[0] || p[1] != old[1];
  }

  bool isNear(ChartVertex v) const {
    const double most = kMostSteps * step_;
    const Point2 now = pointAt(uv_, v), before = pointAt(from_, v);
    return std::abs(now[0] - before[0]) <= most && std::abs(now[1] - before[1]) <= most;
  }

  const DiskChart& chart_;
  double step_;
  std::vector<double>& uv_;
  const std::vector<double> from_;
  /// Of the chart's triangles, followed by those outside the boundary.
  IdVector<ChartCorner, ChartVertex> corners_;
  IdVector<ChartTriangle, std::uint8_t> mayBeFlat_;
  std::vector<std::uint32_t> first_;  ///< per vertex: where its range in `triangles_` begins
  std::vector<ChartTriangle> triangles_;
  std::size_t wrong_ = 0;
};

}  // namespace

GridRepair repairOnGrid(const DiskChart& chart, const std::vector<double>& exact, double step,
                        std::vector<double>& uv) {
  return Repair(chart, exact, step, uv).run();
}

}  // namespace abflat
