// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <cstdint>

namespace abflat {

/// One step of the solver.
struct NewtonStep {
  /// Sum of w (x - a)², with the weights w, the angles x and their targets a.
  double objective = 0;
  /// Largest violation of any constraint; for wheels, of the logarithm, in radians.
  double constraint = 0;
  /// Largest derivative of the Lagrangian, relative to the largest weight times angle.
  double gradient = 0;
  /// Boundary vertices held at their bound.
  std::uint32_t active = 0;
  /// Interior edges held at the Delaunay limit.
  std::uint32_t activeEdges = 0;
  /// Step length, above 0 and at most 1, the full step.
  double step = 0;
  /// Angles that a full step would take to 0 or π: they shorten the step and weigh more from then
  /// on.
  std::uint32_t reweighted = 0;
  /// Iterations of the linear solver; 0 when it is direct.
  int linearIterations = 0;
  /// Time spent on the linear system, in seconds.
  double linearSeconds = 0;
};

template <class Visitor>
void visitFields(const NewtonStep& r, Visitor& v) {
  v.field("objective", r.objective);
  v.field("constraint", r.constraint);
  v.field("gradient", r.gradient);
  v.field("active", r.active);
  v.field("activeEdges", r.activeEdges);
  v.field("step", r.step);
  v.field("reweighted", r.reweighted);
  v.field("linearIterations", r.linearIterations);
}

}  // namespace abflat
