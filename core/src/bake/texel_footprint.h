#pragma once

#include <array>

namespace abflat {

/// How a step of one texel in the new image moves in the old one, in texels: {dx/dx', dx/dy',
/// dy/dx', dy/dy'}.
using Jacobian = std::array<double, 4>;

/// The part of the old image that a texel of the new one covers: probes along its longer axis, each
/// as wide as the shorter axis.
struct TexelFootprint {
  int probes = 1;
  double firstX = 0, firstY = 0;  ///< of the first probe from the middle, in texels
  double stepX = 0, stepY = 0;    ///< from one probe to the next
  int level = 0;                  ///< of the pyramid
  float next = 0;                 ///< the share of the level after it
};

/// `reductions`: levels of the pyramid after the first, at most.
TexelFootprint texelFootprint(const Jacobian& j, int reductions);

}  // namespace abflat
