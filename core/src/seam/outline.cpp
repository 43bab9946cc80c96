#include "seam/outline.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/portable_math.h"
#include "check/crossings.h"

namespace abflat {
namespace {

/// Interior angle at the tail of a boundary half-edge: each triangle's angle changes by half of
/// cot(opposite angle) (u_j - u_i) for both of its edges there.
double flatAngle(const SeamMesh& mesh, const CutSurface& s, SurfaceCorner h, const LogScales& u) {
  const double own = u[mesh.vertexOfCorner[h]];
  // An edge on the boundary has only one triangle.
  double angle = mesh.weight[h] / 2 * (u[mesh.head(h)] - own);
  while (true) {
    angle += mesh.angle[h];
    const SurfaceCorner p = prevCorner(h), o = s.twin[p];
    const double step = mesh.weight[p] * (u[mesh.vertexOfCorner[p]] - own);
    if (!o.exists()) return angle + step / 2;
    angle += step;
    h = o;
  }
}

double turnAt(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Area that is covered more than once, found by sweeping lines over the outline.
double overlapArea(const Outline& p) {
  constexpr std::size_t kLines = 96;
  double low = p.front()[1], high = p.front()[1];
  for (const Point2& q : p) {
    low = std::min(low, q[1]);
    high = std::max(high, q[1]);
  }
  const double step = (high - low) / kLines;
  if (!(step > 0)) return 0;
  std::vector<std::vector<std::pair<double, int>>> hits(kLines);  // x, change of the winding number
  for (const BoundaryIndex i : p.ids()) {
    const Point2 &a = p[i], &b = p[nextAlong(i, p.size())];
    if (a[1] == b[1]) continue;
    const double from = (std::min(a[1], b[1]) - low) / step,
                 to = (std::max(a[1], b[1]) - low) / step;
    for (double line = std::ceil(from - 0.5); line + 0.5 < to && line < kLines; ++line) {
      const double y = low + (line + 0.5) * step;
      const double x = a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]);
      hits[static_cast<std::size_t>(line)].emplace_back(x, a[1] > b[1] ? 1 : -1);
    }
  }
  double sum = 0;
  for (auto& line : hits) {
    std::sort(line.begin(), line.end());
    int winding = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      winding += line[i].second;
      if (winding > 1) sum += (line[i + 1].first - line[i].first) * step;
    }
  }
  return sum;
}

}  // namespace

Outline predictOutline(const SeamMesh& mesh, const CutSurface& s, CutChartId chart,
                       const LogScales& u) {
  const BoundaryLoop boundary = s.outline(chart);
  const std::size_t n = boundary.size();
  IdVector<BoundaryIndex, double> turn(n), lengths(n);
  double total = 0, length = 0;
  for (const BoundaryIndex i : boundary.ids()) {
    const SurfaceCorner h = boundary[i];
    turn[i] = kPi - flatAngle(mesh, s, h, u);
    total += turn[i];
    const double a = u[mesh.tail(h)], b = u[mesh.head(h)];
    lengths[i] = mesh.length[h] * portable::exp((a + b) / 2);
    length += lengths[i];
  }
  Outline out(n);
  Point2 at{0, 0};
  double heading = 0;
  const double lack = (2 * kPi - total) / static_cast<double>(n);
  for (const BoundaryIndex i : boundary.ids()) {
    out[i] = at;
    heading += turn[i] + lack;
    const portable::SinCos direction = portable::sinCos(heading);
    at[0] += lengths[i] * direction.cos;
    at[1] += lengths[i] * direction.sin;
  }
  double passed = 0;  // the gap left when closing is distributed by length
  for (const BoundaryIndex i : boundary.ids()) {
    for (std::size_t d = 0; d < 2; ++d) out[i][d] -= length > 0 ? at[d] * passed / length : 0;
    passed += lengths[i];
  }
  return out;
}

double polygonArea(const Outline& p) {
  double sum = 0;
  for (const BoundaryIndex i : p.ids()) {
    const Point2 &a = p[i], &b = p[nextAlong(i, p.size())];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum / 2;
}

double hullArea(Outline p) {
  std::sort(p.begin(), p.end());
  Outline hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t base = hull.size();
    for (const Point2& q : p) {
      while (hull.size() >= base + 2 &&
             turnAt(hull[BoundaryIndex(hull.size() - 2)], hull.back(), q) <= 0)
        hull.pop_back();
      hull.push_back(q);
    }
    hull.pop_back();
    std::reverse(p.begin(), p.end());
  }
  return polygonArea(hull);
}

double longestExtent(const Outline& outline) {
  constexpr int kDirections = 16;
  double longest = 0;
  for (int k = 0; k < kDirections; ++k) {
    const portable::SinCos along = portable::sinCos(kPi * k / kDirections);
    double low = 0, high = 0;
    for (const Point2& p : outline) {
      const Point2& first = outline.front();
      const double x = (p[0] - first[0]) * along.cos + (p[1] - first[1]) * along.sin;
      low = std::min(low, x);
      high = std::max(high, x);
    }
    longest = std::max(longest, high - low);
  }
  return longest;
}

Shape measureShape(const Outline& outline) {
  Shape shape;
  const double area = polygonArea(outline);
  if (outline.size() < 3) return shape;
  shape.extent = longestExtent(outline);
  if (!(area > 0)) {  // turned inside out, so nothing will fit
    shape.fill = 0;
    return shape;
  }
  shape.fill = std::min(1.0, area / hullArea(outline));
  std::vector<double> points;
  for (const Point2& q : outline) points.insert(points.end(), q.begin(), q.end());
  for (const auto& [i, j] : findCrossings(points, kMostCrossings).first)
    shape.crossings.push_back({BoundaryIndex(i), BoundaryIndex(j)});
  // An outline that does not cross itself covers nothing twice.
  if (!shape.crossings.empty()) shape.overlap = overlapArea(outline) / area;
  return shape;
}

bool overlapsMore(const SeamMesh& mesh, const ToldChart& now, const ToldChart& before,
                  double most) {
  const auto shapeOf = [&](const ToldChart& told) {
    return measureShape(predictOutline(mesh, told.surface, told.chart, told.u));
  };
  const Shape is = shapeOf(now);
  if (is.crossings.empty()) return false;
  const Shape was = shapeOf(before);
  return is.overlap > std::max(was.overlap, most) || is.crossings.size() > was.crossings.size();
}

}  // namespace abflat
