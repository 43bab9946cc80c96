#include "exact/in_circle.h"

#include <cmath>
#include <limits>

#include "exact/exact_sum.h"

namespace abflat {
namespace {

/// |p|^2 times twice the signed area of q, r, s.
template <unsigned N>
void addLiftedArea(ExactSum<N>& sum, double sign, const double* p, const double* q, const double* r,
                   const double* s) {
  const double* corner[] = {q, r, s};
  for (unsigned k = 0; k < 3; ++k) {
    const double *from = corner[k], *to = corner[(k + 1) % 3];
    for (unsigned i = 0; i < 2; ++i) {
      sum.addProduct(sign * p[i], p[i], from[0], to[1]);
      sum.addProduct(-sign * p[i], p[i], from[1], to[0]);
    }
  }
}

}  // namespace

int inCircle(const double* a, const double* b, const double* c, const double* d) {
  const double ax = a[0] - d[0], ay = a[1] - d[1], bx = b[0] - d[0], by = b[1] - d[1];
  const double cx = c[0] - d[0], cy = c[1] - d[1];
  const double aLift = ax * ax + ay * ay, bLift = bx * bx + by * by, cLift = cx * cx + cy * cy;
  const double det =
      aLift * (bx * cy - cx * by) + bLift * (cx * ay - ax * cy) + cLift * (ax * by - bx * ay);
  const double size = aLift * (std::abs(bx * cy) + std::abs(cx * by)) +
                      bLift * (std::abs(cx * ay) + std::abs(ax * cy)) +
                      cLift * (std::abs(ax * by) + std::abs(bx * ay));
  // Shewchuk's first filter, (10 + 96 eps) eps with eps = half an ulp of 1.
  constexpr double kEps = std::numeric_limits<double>::epsilon() / 2;
  constexpr double kBound = (10 + 96 * kEps) * kEps;
  if (std::abs(det) > kBound * size) return det > 0 ? 1 : -1;
  ExactSum<4 * 12 * 8 + 1> sum;
  addLiftedArea(sum, 1, a, b, c, d);
  addLiftedArea(sum, -1, b, a, c, d);
  addLiftedArea(sum, 1, c, a, b, d);
  addLiftedArea(sum, -1, d, a, b, c);
  return sum.sign();
}

}  // namespace abflat
