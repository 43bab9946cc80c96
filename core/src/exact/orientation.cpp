#include "exact/orientation.h"

#include <cmath>
#include <limits>

#include "exact/exact_sum.h"

namespace abflat {
int orientation(const double* a, const double* b, const double* c) {
  const double left = (a[0] - c[0]) * (b[1] - c[1]), right = (a[1] - c[1]) * (b[0] - c[0]);
  const double det = left - right;
  // Shewchuk's first filter, (3 + 16 eps) eps with eps = half an ulp of 1.
  constexpr double kEps = std::numeric_limits<double>::epsilon() / 2;
  constexpr double kBound = (3 + 16 * kEps) * kEps;
  if (std::abs(det) > kBound * (std::abs(left) + std::abs(right))) return det > 0 ? 1 : -1;
  ExactSum<13> sum;
  sum.addProduct(a[0], b[1]);
  sum.addProduct(-a[1], b[0]);
  sum.addProduct(b[0], c[1]);
  sum.addProduct(-b[1], c[0]);
  sum.addProduct(c[0], a[1]);
  sum.addProduct(-c[1], a[0]);
  return sum.sign();
}

}  // namespace abflat
