#pragma once

#include <algorithm>

#include "exact/orientation.h"

namespace abflat {

/// Whether p, which is collinear with a and b, lies between them.
inline bool isBetween(const double* a, const double* b, const double* p) {
  for (int d = 0; d < 2; ++d)
    if (p[d] < std::min(a[d], b[d]) || p[d] > std::max(a[d], b[d])) return false;
  return true;
}

/// Whether the closed segments a b and c d have a point in common, decided exactly.
inline bool segmentsMeet(const double* a, const double* b, const double* c, const double* d) {
  const int abc = orientation(a, b, c), abd = orientation(a, b, d);
  const int cda = orientation(c, d, a), cdb = orientation(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && isBetween(a, b, c)) || (abd == 0 && isBetween(a, b, d)) ||
         (cda == 0 && isBetween(c, d, a)) || (cdb == 0 && isBetween(c, d, b));
}

}  // namespace abflat
