#pragma once

#include <array>

namespace abflat {

/// A linear map of the plane, zeta -> z zeta + w conj(zeta) as complex numbers: (Re z, Im z, Re w,
/// Im w). z is its conformal part. Its singular values are |z| + |w| and |z| - |w|.
using PlaneMap = std::array<double, 4>;

/// With b, the balance, between 0 and 1: (1 - b) (s1/s2 + s2/s1)/2 + b (s1^2 + s2^2 + s1^-2 +
/// s2^-2)/4. The first term (MIPS, Hormann and Greiner 2000) is 1 for similarities, the second
/// (symmetric Dirichlet) for rotations; less is not possible. For maps that keep the orientation.
double elementEnergy(const PlaneMap& map, double balance);

struct ElementDerivatives {
  PlaneMap gradient;
  /// Positive semidefinite: the Hessian without its negative eigenvalues. Rows of the lower
  /// triangle.
  std::array<double, 10> hessian;
};
ElementDerivatives elementDerivatives(const PlaneMap& map, double balance);

}  // namespace abflat
