#include "seam/bend.h"

namespace abflat {

Vec3 facetNormal(const SurfaceMap& map, SurfaceTriangle f) {
  return unitNormal(map.welded().mesh.positions, verticesOf(map.surface().table.vertex, f));
}

double bendBetween(const Vec3& a, const Vec3& b) { return angleBetween(a, b) * (180 / kPi); }

}  // namespace abflat
