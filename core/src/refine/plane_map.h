#pragma once

#include <array>

namespace abflat {

/// A linear map of the plane, zeta -> z zeta + w conj(zeta) as complex numbers: (Re z, Im z, Re w,
/// Im w). z is its conformal part. Its singular values are |z| + |w| and |z| - |w|.
using PlaneMap = std::array<double, 4>;

/// Derivatives of an energy as a function of P = |z|^2 and Q = |w|^2.
struct SquareDerivatives {
  double p, q, pp, pq, qq;
};

inline double determinant(const PlaneMap& m) {
  return m[0] * m[0] + m[1] * m[1] - m[2] * m[2] - m[3] * m[3];
}

}  // namespace abflat
