#pragma once

#include <cstdint>

namespace abflat {

/// One step of the solver.
struct NewtonStep {
  double objective = 0;      ///< sum of w (x - a)^2
  double constraint = 0;     ///< largest violation of any constraint, radians (wheels: of the log)
  double gradient = 0;       ///< largest |dL/dx| relative to the largest weight times angle
  std::uint32_t active = 0;  ///< boundary vertices held at their bound
  std::uint32_t activeEdges = 0;  ///< interior edges held at the Delaunay limit
  double step = 0;                ///< step length in (0, 1]
  /// Angles that the full step would take to 0 or pi: they make it shorter and weigh more from now
  /// on.
  std::uint32_t reweighted = 0;
  int linearIterations = 0;  ///< of the linear solver; 0 when it is direct
  double linearSeconds = 0;  ///< spent on the linear system
};

}  // namespace abflat
