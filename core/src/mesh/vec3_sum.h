#pragma once

#include "mesh/triangle_geometry.h"

namespace abflat {

inline Vec3 sum(Vec3 a, const Vec3& b, double factor = 1) {
  for (std::size_t d = 0; d < 3; ++d) a[d] += factor * b[d];
  return a;
}

/// Of length 1; zero if `a` is.
inline Vec3 unit(Vec3 a) {
  const double length = norm(a);
  if (length > 0)
    for (double& x : a) x /= length;
  return a;
}

}  // namespace abflat
