#pragma once

#include <cstdint>
#include <vector>

#include "solve/linearization.h"

namespace abflat {

/// Where Newton's method stands. Wheel multipliers belong to the logarithmic form (6).
struct NewtonPoint {
  const AngleProblem& problem;
  const std::vector<double>& angles;
  const Multipliers& multipliers;
  const Linearization& lin;
  const std::vector<std::uint8_t>& active;      ///< per vertex
  const std::vector<std::uint8_t>& activeEdge;  ///< per edge of condition (9)
  /// Residual of the linearised vertex constraints that the step may leave, in radians. Solvers
  /// that solve to rounding may ignore it.
  double tolerance = 0;
};

/// Solves eq. (8) at a point: the change dx of the angles and the new multipliers.
class NewtonStepSolver {
 public:
  virtual ~NewtonStepSolver() = default;
  virtual const ConstraintRows& rows() const = 0;
  /// False if the system cannot be solved.
  virtual bool step(const NewtonPoint& at, std::vector<double>& dx, Multipliers& next) = 0;
  /// Iterations of the last step; 0 for a direct solver.
  virtual int linearIterations() const { return 0; }
};

}  // namespace abflat
