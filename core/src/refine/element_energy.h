#pragma once

#include <array>
#include <cstdint>

namespace abflat {

/// A linear map of the plane, zeta -> z zeta + w conj(zeta) as complex numbers: (Re z, Im z, Re w,
/// Im w). z is its conformal part. Its singular values are |z| + |w| and |z| - |w|.
using PlaneMap = std::array<double, 4>;

/// With the balance b between 0 and 1: (1 - b) (s1/s2 + s2/s1)/2 + b (s1^2 + s2^2 + s1^-2 +
/// s2^-2)/4. Both terms are at least 1; the first (MIPS, Hormann and Greiner 2000) is 1 for
/// similarities, the second (symmetric Dirichlet) for rotations. Only for maps that preserve
/// orientation.
double elementEnergy(const PlaneMap& map, double balance);

struct ElementDerivatives {
  PlaneMap gradient;
  /// Positive semidefinite; the lower triangle by rows.
  std::array<double, 10> hessian;
};

/// Near: the Hessian without its negative eigenvalues. Far: along z, the secant towards scale 1
/// replaces the curvature, which would let a triangle grow by only a third however small it is.
enum class ElementCurvature : std::uint8_t { Near, Far };
ElementDerivatives elementDerivatives(const PlaneMap& map, double balance,
                                      ElementCurvature curvature = ElementCurvature::Near);

}  // namespace abflat
