#include "seam/outline.h"

#include <algorithm>

#include "angle/constants.h"
#include "portable_math.h"

namespace abflat {
namespace {

/// Interior angle at the vertex that a boundary half-edge leaves.
double flatAngle(const SeamMesh& mesh, const CutSurface& s, std::uint32_t h,
                 const std::vector<double>& u) {
  double angle = 0;
  while (true) {
    angle += mesh.angle[h];
    const std::uint32_t p = prevCorner(h), o = s.twin[p];
    if (o == kNone) return angle;
    angle += mesh.weight[o] * u[mesh.vertexOfCorner[nextCorner(o)]];
    h = o;
  }
}

double cross(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace

std::vector<Point2> predictOutline(const SeamMesh& mesh, const CutSurface& s, std::uint32_t loop,
                                   const std::vector<double>& u) {
  const std::vector<std::uint32_t>& boundary = s.loops[loop];
  const std::size_t n = boundary.size();
  std::vector<double> turn(n);
  double total = 0, length = 0;
  for (std::size_t i = 0; i < n; ++i) {
    turn[i] = kPi - flatAngle(mesh, s, boundary[i], u);
    total += turn[i];
    length += mesh.length[boundary[i]];
  }
  std::vector<Point2> out(n);
  Point2 at{0, 0};
  double heading = 0;
  const double lack = (2 * kPi - total) / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    out[i] = at;
    heading += turn[i] + lack;
    const portable::SinCos direction = portable::sinCos(heading);
    at[0] += mesh.length[boundary[i]] * direction.cos;
    at[1] += mesh.length[boundary[i]] * direction.sin;
  }
  double passed = 0;  // what is missing to close is shared out by length
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t d = 0; d < 2; ++d) out[i][d] -= length > 0 ? at[d] * passed / length : 0;
    passed += mesh.length[boundary[i]];
  }
  return out;
}

double polygonArea(const std::vector<Point2>& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point2 &a = p[i], &b = p[(i + 1) % p.size()];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum / 2;
}

double hullArea(std::vector<Point2> p) {
  std::sort(p.begin(), p.end());
  std::vector<Point2> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t base = hull.size();
    for (const Point2& q : p) {
      while (hull.size() >= base + 2 && cross(hull[hull.size() - 2], hull.back(), q) <= 0)
        hull.pop_back();
      hull.push_back(q);
    }
    hull.pop_back();
    std::reverse(p.begin(), p.end());
  }
  return polygonArea(hull);
}

}  // namespace abflat
