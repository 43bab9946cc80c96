#include "seam/bend.h"

namespace abflat {

Vec3 facetNormal(const SurfaceMap& map, SurfaceTriangle f) {
  const std::vector<double>& positions = map.welded().mesh.positions;
  const TriangleVertices v = verticesOf(map.surface().table.vertex, f);
  Vec3 n = cross(edgeVector(positions, v[0], v[1]), edgeVector(positions, v[0], v[2]));
  const double length = norm(n);
  for (double& x : n) x = length > 0 ? x / length : 0;
  return n;
}

double bendBetween(const Vec3& a, const Vec3& b) {
  return portable::atan2(norm(cross(a, b)), dot(a, b)) * (180 / kPi);
}

}  // namespace abflat
