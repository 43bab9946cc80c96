#include <chrono>
#include <cmath>
#include <cstdio>

#include "catch.h"
#include "research/kkt_step_solver.h"
#include "research/wheel_product.h"
#include "solve/active_set.h"
#include "solve/newton_system.h"
#include "support/instrumented.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

constexpr LinearSolver kIterative[] = {LinearSolver::Minres, LinearSolver::Symmlq,
                                       LinearSolver::Gmres, LinearSolver::Bicgstab};

SolverOptions toTheEnd() {
  SolverOptions options;
  options.gradientTolerance = 1e-8;
  options.objectiveTolerance = 0;
  options.maxSteps = 30;
  return options;
}

void printRow(const char* name, const char* solver, Formulation form, bool precondition,
              const AngleSolution& s, double difference) {
  int linear = 0;
  double seconds = 0;
  for (const NewtonStep& h : s.history) linear += h.linearIterations, seconds += h.linearSeconds;
  std::printf("%-12s %-8s %-7s %-7s newton %2zu linear %6d  %8.3f s  %s %.1e\n", name, solver,
              form == Formulation::Log ? "log" : "product", precondition ? "precond" : "plain",
              s.history.size(), linear, seconds, s.converged ? "converged" : "FAILED   ",
              difference);
  std::fflush(stdout);
}

void compareAll(const char* name, const PolygonMesh& mesh, double t) {
  const AngleProblem problem = problemOf(mesh, t);
  NewtonSystem direct(problem);
  const AngleSolution wanted = solveActiveSet(problem, direct, toTheEnd());
  REQUIRE(wanted.converged);
  printRow(name, "schur", Formulation::Log, true, wanted, 0);
  for (Formulation form : {Formulation::Log, Formulation::Product})
    for (LinearSolver solver : kIterative) {
      KktStepSolver system(problem, {solver, form, true});
      const AngleSolution s = solveActiveSet(problem, system, toTheEnd());
      double worst = 0;
      for (std::size_t c = 0; c < s.angles.size(); ++c)
        worst = std::max(worst, std::abs(s.angles[c] - wanted.angles[c]));
      printRow(name, nameOf(solver), form, true, s, worst);
      CHECK(s.converged);
      CHECK(worst <= 1e-8);
    }
}

}  // namespace

TEST_CASE("first and second derivatives of the product wheels match central differences") {
  const AngleProblem problem = problemOf(bumpyGrid(4, 3, 0.4, 2), 1.1);
  const ConstraintRows rows = numberRows(problem);
  RandomPoint point(problem, rows, 3);
  const VertexCorners fans = cornersOfVertices(problem);
  const std::size_t n = point.x.size();
  const auto cotangents = [&](const std::vector<double>& x) {
    std::vector<double> cot(n);
    for (std::size_t c = 0; c < n; ++c) cot[c] = 1 / std::tan(x[c]);
    return cot;
  };
  const auto gradient = [&](const std::vector<double>& x, ChartVertex v) {
    Linearization lin;
    linearize(problem, rows, {x, point.multipliers.row, Curvature::Exact}, lin);
    const std::vector<std::uint8_t> active(problem.vertexCount(), 1);
    const KktSystem kkt =
        buildKkt({problem, x, point.multipliers, lin, active, {}}, rows, Formulation::Product);
    const auto row = static_cast<int>(n + n / 3 + rows.ofVertex[v] + 1);
    std::vector<double> g(n);
    for (std::size_t c = 0; c < n; ++c) g[c] = kkt.matrix.coeff(row, static_cast<int>(c));
    return g;
  };
  for (const ChartVertex v : problem.vertices()) {
    if (problem.isBoundary[v]) continue;
    const std::vector<double> g = gradient(point.x, v);
    std::vector<double> hessian(n * n, 0);
    forEachSecondDerivative(
        fans, cotangents(point.x), wheelProducts(problem, point.x)[v], v,
        [&](ChartCorner i, ChartCorner j, double value) { hessian[i * n + j] += value; });
    for (std::size_t c = 0; c < n; ++c) {
      std::vector<double> above = point.x, below = point.x;
      above[c] += 1e-6;
      below[c] -= 1e-6;
      const double slope =
          (wheelProducts(problem, above)[v].value() - wheelProducts(problem, below)[v].value()) /
          2e-6;
      CHECK(g[c] == Approx(slope).margin(1e-8));
      const std::vector<double> ga = gradient(above, v), gb = gradient(below, v);
      for (std::size_t i = 0; i < n; ++i)
        CHECK(hessian[i * n + c] == Approx((ga[i] - gb[i]) / 2e-6).margin(1e-7));
    }
  }
}

TEST_CASE("iterative solvers do not go on for longer than the number of rows calls for") {
  // Heights far larger than the squares give angles near 0, and systems that are almost singular.
  const AngleProblem problem = problemOf(bumpyGrid(4, 3, 40, 1), 2);
  const int rows = static_cast<int>(problem.target.size() + problem.triangleCount() +
                                    numberRows(problem).count());
  SolverOptions options = toTheEnd();
  options.maxSteps = 10;
  for (const bool precondition : {true, false})
    for (const Formulation form : {Formulation::Log, Formulation::Product})
      for (const LinearSolver solver : kIterative) {
        KktStepSolver system(problem, {solver, form, precondition});
        const AngleSolution s = solveActiveSet(problem, system, options);
        INFO(nameOf(solver) << " " << precondition);
        for (const NewtonStep& step : s.history)
          CHECK(step.linearIterations <= (precondition ? 100 + rows : 8 * rows));
      }
}

TEST_CASE("all linear solvers and both formulations find the same angles") {
  for (double t : {2.0, 1.0}) compareAll("grid", bumpyGrid(6, 5, 0.3, 1), t);
}

TEST_CASE("all linear solvers and both formulations agree on the shared meshes") {
  for (const char* file : {"nefertiti.off", "hemisphere.obj", "body.off", "cathead.obj"}) {
    const PolygonMesh mesh = sharedMesh(file);
    if (mesh.faceCount() == 0) return;
    if (mesh.faceCount() > cases(100000u, 600u)) continue;
    compareAll(file, mesh, 1);
  }
}
