#pragma once

#include <cstdint>
#include <vector>

#include "angle/angle_problem.h"
#include "base/parallel.h"
#include "solve/element.h"

namespace abflat {

/// Numbering of the vertex constraints: one row for a boundary vertex (angle sum), two for an
/// interior one (angle sum, wheel). Boundary rows stay in the system when they are inactive, so its
/// pattern never changes.
struct ConstraintRows {
  std::vector<std::uint32_t>
      ofVertex;  ///< row of the angle sum; the wheel's row follows it. Size V+1
  std::uint32_t count() const { return ofVertex.back(); }
};
ConstraintRows numberRows(const AngleProblem& problem);

/// Per row: 0 for an angle sum, 1 for a wheel.
std::vector<std::uint8_t> rowKinds(const ConstraintRows& rows);

/// Multipliers (eq. 8): one per row, per triangle and, with condition (9), per edge. Those of
/// inactive rows and edges are 0.
struct Multipliers {
  std::vector<double> row;
  std::vector<double> triangle;
  std::vector<double> edge;
};

/// Logarithmic barrier -tau sum log x_c that keeps angles away from 0, with its dual variables z_c
/// (about tau / x_c).
struct Barrier {
  double tau = 0;
  std::vector<double> dual;  ///< z per corner, > 0
};

/// Clamped keeps each h at a share of w or above, so that the element matrices are semidefinite:
/// robust far from the solution, but it converges linearly where it clamps. Exact converges
/// quadratically, near the solution only.
enum class Curvature { Clamped, Exact };

/// The problem's first and second derivatives at angles x and multipliers.
struct Linearization {
  std::vector<Element> elements;  ///< per triangle
  std::vector<double> residual;   ///< h and g per row: (1), (6) and, for boundary rows, sum - bound
  std::vector<double> edgeResidual;  ///< per edge of condition (9): sum - limit
  double objective = 0;
  std::vector<double> logSine;  ///< per corner
};
/// Where and how to linearise.
struct LinearizationPoint {
  const std::vector<double>& angles;
  const std::vector<double>& rowMultipliers;
  Curvature curvature;
  const Barrier* barrier = nullptr;
};
/// From here on, results do not depend on `pool`; null: one thread.
void linearize(const AngleProblem& problem, const ConstraintRows& rows,
               const LinearizationPoint& at, Linearization& out, ThreadPool* pool = nullptr);

/// The six row values of triangle f's vertices; rows that do not exist (wheels on the boundary)
/// read as 0.
inline std::array<double, 6> gatherRows(const AngleProblem& problem, const ConstraintRows& rows,
                                        const std::vector<double>& values, ChartTriangle f) {
  std::array<double, 6> y;
  for (std::size_t k = 0; k < 3; ++k) {
    const ChartVertex v = problem.vertexOfCorner[cornerOf(f, k)];
    y[2 * k] = values[rows.ofVertex[v]];
    y[2 * k + 1] = problem.isBoundary[v] ? 0 : values[rows.ofVertex[v] + 1];
  }
  return y;
}

/// Largest violation of any constraint, radians (wheels: of the logarithm).
double constraintResidual(const AngleProblem& problem, const ConstraintRows& rows,
                          const Linearization& lin, ThreadPool* pool = nullptr);

/// Largest a_c |dL/dx_c| / 2: the gradient of the Lagrangian in units of the relative change of an
/// angle.
double gradientResidual(const AngleProblem& problem, const ConstraintRows& rows,
                        const Linearization& lin, const Multipliers& multipliers,
                        ThreadPool* pool = nullptr);

}  // namespace abflat
