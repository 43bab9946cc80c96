#include "refine/element_energy.h"

#include <algorithm>
#include <cmath>

namespace abflat {
namespace {

/// A symmetric 2x2 matrix.
struct Symmetric2 {
  double xx, xy, yy;
};

/// The matrix without its negative eigenvalues.
Symmetric2 projected(const Symmetric2& m) {
  const double mean = (m.xx + m.yy) / 2, half = (m.xx - m.yy) / 2;
  const double radius = std::sqrt(half * half + m.xy * m.xy);
  const double low = mean - radius, high = mean + radius;
  if (low >= 0) return m;
  if (high <= 0) return {0, 0, 0};
  // high times the projection on its eigenvector.
  const double scale = high / (2 * radius);
  return {scale * (radius + half), scale * m.xy, scale * (radius - half)};
}

}  // namespace

double elementEnergy(const PlaneMap& m, const Energy& energy) {
  return energy.at(m[0] * m[0] + m[1] * m[1], m[2] * m[2] + m[3] * m[3]);
}

ElementDerivatives elementDerivatives(const PlaneMap& m, const Energy& energy,
                                      ElementCurvature curvature) {
  const double p = m[0] * m[0] + m[1] * m[1], q = m[2] * m[2] + m[3] * m[3];
  const SquareDerivatives d = energy.derivatives(p, q);
  ElementDerivatives out;
  for (std::size_t i = 0; i < 2; ++i) {
    out.gradient[i] = 2 * d.p * m[i];
    out.gradient[2 + i] = 2 * d.q * m[2 + i];
  }
  // Along z and along w, and, apart from these, across z (a rotation) and across w.
  const double rootP = std::sqrt(p), rootQ = std::sqrt(q);
  const double share = curvature == ElementCurvature::Far ? energy.secantShare(rootP) : 1;
  const Symmetric2 r =
      projected({share * (2 * d.p + 4 * p * d.pp), std::sqrt(share) * 4 * rootP * rootQ * d.pq,
                 2 * d.q + 4 * q * d.qq});
  const double acrossZ = std::max(2 * d.p, 0.0), acrossW = std::max(2 * d.q, 0.0);
  const double zx = m[0] / rootP, zy = m[1] / rootP;
  const double wx = rootQ > 0 ? m[2] / rootQ : 1, wy = rootQ > 0 ? m[3] / rootQ : 0;
  out.hessian = {r.xx * zx * zx + acrossZ * zy * zy,
                 (r.xx - acrossZ) * zx * zy,
                 r.xx * zy * zy + acrossZ * zx * zx,
                 r.xy * zx * wx,
                 r.xy * zy * wx,
                 r.yy * wx * wx + acrossW * wy * wy,
                 r.xy * zx * wy,
                 r.xy * zy * wy,
                 (r.yy - acrossW) * wx * wy,
                 r.yy * wy * wy + acrossW * wx * wx};
  return out;
}

}  // namespace abflat
