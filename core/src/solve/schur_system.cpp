#include "solve/schur_system.h"

#include <algorithm>

namespace abflat {
namespace {

constexpr std::size_t kAssemblyGrain = 2048;  ///< triangles per piece of work

}  // namespace

SchurSystem::SchurSystem(const AngleProblem& problem, const ConstraintRows& rows, ThreadPool* pool)
    : problem_(problem),
      rows_(rows),
      pool_(pool),
      system_(problem.vertexOfCorner, rows.ofVertex, pool) {}

void SchurSystem::assemble(const Linearization& lin, const std::vector<std::uint8_t>& active,
                           const std::vector<double>& compliance) {
  IdVector<ChartVertex, std::uint8_t> isOff(problem_.vertexCount());
  for (const ChartVertex v : problem_.vertices()) isOff[v] = problem_.isBoundary[v] && !active[v];
  std::copy(lin.residual.begin(), lin.residual.end(), system_.rightHandSide.begin());
  system_.assemble(isOff, [&](ChartTriangle f) {
    const Element& e = lin.elements[f];
    TriangleRows out{elementMatrix(e), {}};
    // h - B P g - B D 1 r / (1^T D 1)
    std::array<double, 3> z = applyProjected(e, e.gradient);
    const std::array<double, 3> unit = unitStep(e);
    for (unsigned k = 0; k < 3; ++k) z[k] += unit[k] * e.triangleResidual;
    out.rightHandSide = applyJacobian(e, z);
    for (double& y : out.rightHandSide) y = -y;
    return out;
  });
  if (compliance.empty()) return;
  for (const ChartVertex v : problem_.vertices())
    if (problem_.isBoundary[v] && active[v]) *system_.diagonal(rows_.ofVertex[v]) += compliance[v];
}

void SchurSystem::backSubstitute(const Linearization& lin,
                                 const std::vector<double>& rowMultipliers, std::vector<double>& dx,
                                 std::vector<double>& triangleMultipliers) const {
  dx.resize(problem_.vertexOfCorner.size());
  triangleMultipliers.resize(problem_.triangleCount());
  parallelRanges(pool_, problem_.triangleCount(), kAssemblyGrain,
                 [&](std::size_t begin, std::size_t end) {
                   for (const ChartTriangle f : IdRange{ChartTriangle(begin), ChartTriangle(end)}) {
                     const Element& e = lin.elements[f];
                     std::array<double, 3> z =
                         applyTransposedJacobian(e, gatherRows(problem_, rows_, rowMultipliers, f));
                     for (unsigned k = 0; k < 3; ++k) z[k] += e.gradient[k];
                     const std::array<double, 3> step = applyProjected(e, z), unit = unitStep(e);
                     double& lambda = triangleMultipliers[f];
                     lambda = e.triangleResidual * e.hessian[0] * unit[0];
                     for (unsigned k = 0; k < 3; ++k) {
                       lambda -= unit[k] * z[k];
                       dx[cornerOf(f, k)] = -step[k] - unit[k] * e.triangleResidual;
                     }
                   }
                 });
}

}  // namespace abflat
