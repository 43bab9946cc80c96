#pragma once

#include <array>
#include <cstdint>

#include "refine/energy.h"

namespace abflat {

double elementEnergy(const PlaneMap& map, const Energy& energy);

struct ElementDerivatives {
  PlaneMap gradient;
  /// Positive semidefinite; the lower triangle by rows.
  std::array<double, 10> hessian;
};

/// Near: the Hessian without its negative eigenvalues. Far: along z, the secant towards scale 1
/// replaces the curvature.
enum class ElementCurvature : std::uint8_t { Near, Far };
ElementDerivatives elementDerivatives(const PlaneMap& map, const Energy& energy,
                                      ElementCurvature curvature = ElementCurvature::Near);

}  // namespace abflat
