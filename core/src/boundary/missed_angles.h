#pragma once

#include <cstddef>
#include <vector>

#include "chart/disk_chart.h"

namespace abflat {

/// Radians that rounding to double precision may cost; single precision costs more.
constexpr double kAngleRounding = 1e-6, kAngleRoundingInSingle = 1e-3;

/// Boundary angles of a layout that differ by more than rounding from what was asked for.
struct MissedAngles {
  std::size_t count = 0;
  double most = 0;  ///< radians
};

/// Angles above their bounds (in units of pi). Straight places have no bound.
MissedAngles exceededBounds(const DiskChart& chart, const std::vector<double>& uv,
                            const BoundaryBounds& t, const StraightPlaces& straight = {},
                            double rounding = kAngleRounding);

/// Angles at straight places that are not pi.
MissedAngles bentPlaces(const DiskChart& chart, const std::vector<double>& uv,
                        const StraightPlaces& straight, double rounding = kAngleRounding);

}  // namespace abflat
