#include "solve/active_set.h"

#include <cmath>

#include "base/constants.h"
#include "catch.h"
#include "mesh/corner_table.h"
#include "solve/angle_solver.h"
#include "solve/delaunay_system.h"
#include "solve/newton_system.h"
#include "support/dense_kkt.h"
#include "support/instrumented.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

AngleSolution solved(const AngleProblem& problem, const SolverOptions& options) {
  NewtonSystem system(problem);
  return solveActiveSet(problem, system, options);
}

/// Stops only when the gradient vanishes, not when the objective stands still.
SolverOptions toTheEnd() {
  SolverOptions options;
  options.gradientTolerance = 1e-9;
  options.objectiveTolerance = 0;
  return options;
}

/// Checks the conditions for a minimum (Karush, Kuhn, Tucker), using residuals that share no code
/// with the solver's steps.
void checkOptimal(const AngleProblem& problem, const AngleSolution& s) {
  const ConstraintRows rows = numberRows(problem);
  REQUIRE(s.converged);
  std::vector<double> sum(problem.vertexCount(), 0), wheel(problem.vertexCount(), 0);
  for (const ChartTriangle f : problem.triangles()) {
    const double* x = &s.angles[3 * f];
    CHECK(std::abs(x[0] + x[1] + x[2] - kPi) < 1e-10);
    for (std::uint32_t k = 0; k < 3; ++k) {
      CHECK(x[k] > 0);
      const ChartVertex v = problem.vertexOfCorner[cornerOf(f, k)];
      sum[v] += x[k];
      wheel[v] += std::log(std::sin(x[(k + 1) % 3])) - std::log(std::sin(x[(k + 2) % 3]));
    }
  }
  for (const ChartVertex v : problem.vertices()) {
    const double mu = s.multipliers.row[rows.ofVertex[v]];
    if (problem.isBoundary[v]) {
      CHECK(sum[v] <= problem.angleSum[v] + 1e-10);
      CHECK(mu >= 0);
      if (!s.active[v]) CHECK(mu == 0);
      if (s.active[v]) CHECK(std::abs(sum[v] - problem.angleSum[v]) < 1e-10);
    } else {
      CHECK(std::abs(sum[v] - 2 * kPi) < 1e-10);
      CHECK(std::abs(wheel[v]) < 1e-10);
    }
  }
  for (const ChartTriangle f : problem.triangles())
    for (std::uint32_t k = 0; k < 3; ++k) {
      const ChartCorner c = cornerOf(f, k);
      const ChartVertex n = problem.vertexOfCorner[nextCorner(c)],
                        p = problem.vertexOfCorner[prevCorner(c)];
      const auto wheelMultiplier = [&](ChartVertex v) {
        return problem.isBoundary[v] ? 0 : s.multipliers.row[rows.ofVertex[v] + 1];
      };
      const double a = problem.target[c];
      const double w = s.weight.empty() ? 1 / (a * a) : s.weight[c];
      const std::uint32_t edge = problem.edgeOfCorner.empty() ? kNone : problem.edgeOfCorner[c];
      const double g = 2 * w * (s.angles[c] - a) + s.multipliers.triangle[f] +
                       (edge == kNone ? 0 : s.multipliers.edge[edge]) +
                       s.multipliers.row[rows.ofVertex[problem.vertexOfCorner[c]]] +
                       (wheelMultiplier(p) - wheelMultiplier(n)) / std::tan(s.angles[c]);
      CHECK(std::abs(g) * a / 2 < 1e-8);
    }
  for (std::size_t i = 0; i < problem.edgeCorners.size(); ++i) {
    const auto [c, d] = problem.edgeCorners[i];
    const double slack = problem.edgeLimit - s.angles[c] - s.angles[d];
    CHECK(slack >= -1e-10);
    CHECK(s.multipliers.edge[i] >= 0);
    if (!s.activeEdge[i]) CHECK(s.multipliers.edge[i] == 0);
    if (s.activeEdge[i]) CHECK(std::abs(slack) < 1e-10);
  }
}

/// The minimum with condition (9), starting from the one without.
AngleSolution solvedDelaunay(AngleProblem& problem, const DiskChart& chart) {
  const AngleSolution plain = solved(problem, toTheEnd());
  setDelaunay(problem, chart, 0);
  DelaunaySystem system(problem);
  SolverOptions options = toTheEnd();
  options.maxSteps = 200;
  return solveActiveSet(problem, system, options, &plain);
}

}  // namespace

TEST_CASE("the solution meets all constraints and the conditions for a minimum") {
  for (double t : {2.0, 1.3, 1.0}) {
    for (unsigned seed : {1u, 2u, 3u}) {
      const AngleProblem problem = problemOf(bumpyGrid(12, 9, 0.35, seed), t);
      checkOptimal(problem, solved(problem, toTheEnd()));
    }
    const AngleProblem problem = problemOf(cone(7, 0.8), t);
    checkOptimal(problem, solved(problem, toTheEnd()));
  }
}

TEST_CASE("shared disks converge to a minimum") {
  for (const char* file :
       {"nefertiti.off", "body.off", "cathead.obj", "mannequin.off", "face.obj", "hemisphere.obj",
        "inspired.obj", "woody.obj", "nonconvex-cap.off", "camel-cut.obj", "cow-cut.off"}) {
    const PolygonMesh mesh = sharedMesh(file);
    if (mesh.faceCount() == 0) return;
    if (mesh.faceCount() > cases(100000u, 3000u)) continue;
    INFO(file);
    const bool isCut = std::string(file).find("-cut") != std::string::npos;
    for (double t : isCut ? std::vector<double>{2, 1.8} : std::vector<double>{2, 1.05, 1}) {
      const AngleProblem problem = problemOf(mesh, t);
      checkOptimal(problem, solved(problem, toTheEnd()));
    }
  }
}

TEST_CASE("with the Delaunay condition the solution is a minimum as well") {
  for (double t : {2.0, 1.0})
    for (unsigned seed : {1u, 2u, 3u}) {
      const DiskChart chart = chartOf(bumpyGrid(10, 9, 0.35, seed));
      AngleProblem problem = problemOf(chart, t);
      const AngleSolution s = solvedDelaunay(problem, chart);
      checkOptimal(problem, s);
      CHECK(s.history.back().activeEdges > 0);
    }
}

TEST_CASE("angles that would leave their range weigh more until the way is free") {
  std::size_t raised = 0;
  for (unsigned seed = 1; seed <= 9; ++seed) {
    const AngleProblem problem = problemOf(bumpyGrid(5 + seed, 5 + seed, 4, seed), 1);
    const AngleSolution s = solved(problem, toTheEnd());
    std::uint32_t reweighted = 0;
    for (const NewtonStep& step : s.history) {
      if (step.reweighted > 0) CHECK(step.step < 0.1);
      reweighted += step.reweighted;
    }
    if (!s.converged || reweighted == 0) continue;
    ++raised;
    checkOptimal(problem, s);
    for (const ChartCorner c : IdRange<ChartCorner>(s.weight.size()))
      CHECK(s.weight[c] >= problem.weight[c]);
  }
  CHECK(raised > 0);
}

TEST_CASE("a flat convex mesh keeps its angles") {
  const AngleProblem problem = problemOf(bumpyGrid(1, 1, 0, 1), 1);
  const AngleSolution s = solved(problem, {});
  REQUIRE(s.converged);
  CHECK(s.history.back().objective < 1e-20);
}

TEST_CASE("the smallest possible bound gives a regular outline") {
  // With t = 1 - 2/n all boundary angles are at their bound.
  const AngleProblem problem = problemOf(cone(9, 0.5), 1 - 2.0 / 9 + 1e-9);
  const AngleSolution s = AngleSolver(problem, {}).solve(nullptr);
  REQUIRE(s.converged);
  for (std::size_t c = 0; c < s.angles.size(); c += 3) CHECK(s.angles[c] == Approx(2 * kPi / 9));
}

TEST_CASE("returning false from onStep stops the solver") {
  SolverOptions options;
  int calls = 0;
  options.onStep = [&](const NewtonStep&) { return ++calls < 2; };
  const AngleSolution s = solved(problemOf(bumpyGrid(10, 10, 0.4, 1), 1), options);
  CHECK(s.isEnded);
  CHECK_FALSE(s.converged);
  CHECK(calls == 2);
}
