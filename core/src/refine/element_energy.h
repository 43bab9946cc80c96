#pragma once

#include <array>
#include <cstdint>

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
  /// Positive semidefinite. Rows of the lower triangle.
  std::array<double, 10> hessian;
};

/// Near: the Hessian without its negative eigenvalues. Far: along z with the secant towards scale 1
/// in place of the curvature, which lets a triangle grow by a third at most, however small it is.
enum class ElementCurvature : std::uint8_t { Near, Far };
ElementDerivatives elementDerivatives(const PlaneMap& map, double balance,
                                      ElementCurvature curvature = ElementCurvature::Near);

}  // namespace abflat
