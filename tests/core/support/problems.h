#pragma once

#include <random>

#include "angle/angle_problem.h"
#include "chart/disk_chart.h"
#include "mesh/surface.h"
#include "solve/linearization.h"

namespace abflat::test {

inline DiskChart chartOf(const PolygonMesh& mesh) {
  return makeDiskChart(mesh, buildSurface(mesh));
}
inline AngleProblem problemOf(const DiskChart& chart, double t) {
  AngleProblem problem = buildAngleProblem(chart);
  setBounds(problem, chart, BoundaryBounds(chart.boundary.size(), t));
  return problem;
}
inline AngleProblem problemOf(const PolygonMesh& mesh, double t) {
  return problemOf(chartOf(mesh), t);
}

/// Angles near the targets that satisfy no constraint, and multipliers of both signs.
struct RandomPoint {
  std::vector<double> x;
  Multipliers multipliers;

  RandomPoint(const AngleProblem& problem, const ConstraintRows& rows, unsigned seed)
      : x(problem.target.raw()) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> change(-0.1, 0.1);
    for (double& angle : x) angle *= 1 + change(random);
    multipliers.row.resize(rows.count());
    multipliers.triangle.resize(problem.triangleCount());
    for (double& m : multipliers.row) m = change(random);
    for (double& m : multipliers.triangle) m = change(random);
  }
};

}  // namespace abflat::test
