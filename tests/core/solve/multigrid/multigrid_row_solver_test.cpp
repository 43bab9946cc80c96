#include "solve/multigrid/multigrid_row_solver.h"

#include <algorithm>
#include <cmath>

#include "abflat/flatten.h"
#include "catch.h"
#include "solve/active_set.h"
#include "solve/angle_solver.h"
#include "solve/newton_system.h"
#include "support/instrumented.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

constexpr std::uint64_t kLittle = 100 << 10;  // bytes

double largestDifference(const AngleSolution& a, const AngleSolution& b) {
  double worst = 0;
  for (std::size_t c = 0; c < a.angles.size(); ++c)
    worst = std::max(worst, std::abs(a.angles[c] - b.angles[c]));
  return worst;
}

/// The same problem with and without a memory limit; either both converge or neither.
void compareLimits(const AngleProblem& problem) {
  SolverOptions options;
  AngleSolver usual(problem, options);
  options.allowedBytes = kLittle;
  AngleSolver limited(problem, options);
  CHECK(usual.memory().fits());
  CHECK(usual.memory().needed == limited.memory().needed);
  const AngleSolution a = usual.solve(nullptr), b = limited.solve(nullptr);
  CHECK(a.converged == b.converged);
  CHECK(a.barrierFloor == b.barrierFloor);
  if (!a.converged || !b.converged) return;
  CHECK(b.constraintResidual <= options.constraintTolerance);
  CHECK(b.history.back().objective ==
        Approx(a.history.back().objective).epsilon(1e-8).margin(1e-12));
  // Where the exact Hessian is indefinite, the limited solver continues with the clamped one, which
  // converges linearly, and stops by the change of the objective.
  const bool isQuadratic = a.history.size() == b.history.size() && a.barrierFloor == 0;
  CHECK(largestDifference(a, b) < (isQuadratic ? 1e-8 : 1e-5));
}

}  // namespace

TEST_CASE("a factor that does not fit is done without") {
  const AngleProblem problem = problemOf(bumpyGrid(60, 60, 0.3, 1), 2);
  const NewtonSystem roomy(problem, ~std::uint64_t{0});
  REQUIRE(roomy.memory().fits());
  const std::uint64_t needed = roomy.memory().needed;
  CHECK(NewtonSystem(problem, needed).memory().fits());
  CHECK_FALSE(NewtonSystem(problem, needed - 1).memory().fits());
  const std::uint64_t single = roomy.memory().neededInSingle;
  CHECK(single < needed);
  NewtonSystem direct(problem);
  const AngleSolution wanted = solveActiveSet(problem, direct, {}, nullptr);
  for (const std::uint64_t allowed : {needed - 1, single, single - 1}) {
    NewtonSystem limited(problem, allowed);
    CHECK(limited.memory().fitsInSingle() == (allowed >= single));
    const AngleSolution s = solveActiveSet(problem, limited, {}, nullptr);
    CHECK(s.converged);
    CHECK(largestDifference(s, wanted) < 1e-8);
    for (const NewtonStep& step : s.history) CHECK(step.linearIterations > 0);
  }
}

TEST_CASE("where single precision must do, the interior point converges all the same") {
  const AngleProblem problem = problemOf(bumpyGrid(cases(50u, 25u), 50, 0.3, 5), 1);
  SolverOptions options;
  AngleSolver usual(problem, options);
  options.allowedBytes = usual.memory().needed - 1;
  AngleSolver limited(problem, options);
  REQUIRE(limited.memory().fitsInSingle());
  const AngleSolution a = usual.solveWithFloor(1e-2), b = limited.solveWithFloor(1e-2);
  REQUIRE(a.converged);
  REQUIRE(b.converged);
  CHECK(largestDifference(a, b) < 1e-8);
}

TEST_CASE("little memory leads to the same angles on generated disks") {
  for (const PolygonMesh& mesh :
       {bumpyGrid(60, 45, 0.3, 3), bumpyGrid(cases(100u, 50u), 100, 0.2, 4)})
    for (const double t : {1.0, 2.0}) compareLimits(problemOf(mesh, t));
}

TEST_CASE("the interior point does with little memory") {
  const AngleProblem problem = problemOf(bumpyGrid(cases(50u, 25u), 50, 0.3, 5), 1);
  SolverOptions options;
  AngleSolver usual(problem, options);
  options.allowedBytes = kLittle;
  AngleSolver limited(problem, options);
  REQUIRE_FALSE(limited.memory().fits());
  const AngleSolution a = usual.solveWithFloor(1e-2), b = limited.solveWithFloor(1e-2);
  REQUIRE(a.converged);
  REQUIRE(b.converged);
  CHECK(largestDifference(a, b) < 1e-8);
}

TEST_CASE("little memory leads to the same angles on every shared mesh") {
  for (const char* file :
       {"body.off", "camel-cut.obj", "cathead.obj", "cow-cut.off", "face.obj", "hemisphere.obj",
        "inspired.obj", "mannequin.off", "nefertiti.off", "nonconvex-cap.off", "woody.obj"}) {
    const PolygonMesh mesh = sharedMesh(file);
    if (mesh.faceCount() == 0) return;
    if (mesh.faceCount() > cases(100000u, 2000u)) continue;
    const Surface surface = buildSurface(mesh);
    if (!surface.summary.disk.ok()) continue;
    const DiskChart chart = makeDiskChart(mesh, surface);
    for (const double t : {1.0, 2.0}) {
      INFO(file << " t = " << t);
      compareLimits(problemOf(chart, t));
    }
  }
}

TEST_CASE("the report says what a factor needs and what it may take") {
  const PolygonMesh mesh = bumpyGrid(60, 60, 0.3, 1);
  FlattenOptions options;
  options.t = 2;
  options.memory = 1;
  const Result<FlattenResult> limited = flatten(mesh, options);
  REQUIRE(limited.ok());
  CHECK(limited.value().report.valid);
  const std::vector<std::string>& notes = limited.value().report.charts[0].fallbacks;
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], Catch::Contains("needs ") && Catch::Contains("only 1 MB are allowed") &&
                           Catch::Contains("multigrid"));
  SECTION("Delaunay") {
    options.delaunay = true;
    const Result<FlattenResult> delaunay = flatten(mesh, options);
    REQUIRE(delaunay.ok());
    CHECK(delaunay.value().uv == limited.value().uv);
    CHECK_THAT(delaunay.value().report.charts[0].fallbacks.back(),
               Catch::StartsWith("the layout is not Delaunay: factoring"));
  }
  SECTION("enough memory") {
    options.memory = 1000;
    const Result<FlattenResult> usual = flatten(mesh, options);
    REQUIRE(usual.ok());
    CHECK(usual.value().report.charts[0].fallbacks.empty());
  }
}
