#include "mesh/project_polygon.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace abflat {

std::vector<Point2> projectPolygon(const std::vector<double>& positions,
                                   const std::uint32_t* vertices, std::size_t count) {
  const double* origin = &positions[3 * static_cast<std::size_t>(vertices[0])];
  std::vector<std::array<double, 3>> p(count);
  double size = 0;
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t d = 0; d < 3; ++d) {
      p[k][d] = positions[3 * static_cast<std::size_t>(vertices[k]) + d] - origin[d];
      size = std::max(size, std::abs(p[k][d]));
    }
  std::array<double, 3> normal{0, 0, 0};
  for (std::size_t k = 0; k < p.size(); ++k) {
    for (double& x : p[k])
      if (size > 0) x /= size;
    if (k == 0) continue;
    const auto& a = p[k - 1];
    const auto& b = p[k];
    for (std::size_t d = 0; d < 3; ++d)
      normal[d] += a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3];
  }
  // Dropping the coordinate of the largest normal component keeps orientation and convexity.
  std::size_t drop = 0;
  for (std::size_t d = 1; d < 3; ++d)
    if (std::abs(normal[d]) > std::abs(normal[drop])) drop = d;
  const bool flip = normal[drop] < 0;
  std::vector<Point2> q(p.size());
  for (std::size_t k = 0; k < p.size(); ++k) {
    q[k] = {p[k][(drop + 1) % 3], p[k][(drop + 2) % 3]};
    if (flip) std::swap(q[k][0], q[k][1]);
  }
  return q;
}

}  // namespace abflat
