#include "solve/interior_point.h"

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "solve/active_set.h"
#include "solve/newton_system.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

AngleSolution byInteriorPoint(const AngleProblem& problem, double floor) {
  NewtonSystem system(problem);
  InteriorPointOptions options;
  options.barrierFloor = floor;
  options.common.maxSteps = 200;
  return solveInteriorPoint(problem, system, options);
}

AngleSolution byActiveSet(const AngleProblem& problem) {
  NewtonSystem system(problem);
  return solveActiveSet(problem, system, {});
}

}  // namespace

TEST_CASE("with a vanishing barrier the interior point finds the active set's minimum") {
  for (double t : {2.0, 1.1, 1.0})
    for (unsigned seed : {1u, 2u}) {
      const AngleProblem problem = problemOf(bumpyGrid(8, 7, 0.35, seed), t);
      const AngleSolution a = byActiveSet(problem), b = byInteriorPoint(problem, 1e-11);
      REQUIRE(a.converged);
      REQUIRE(b.converged);
      for (std::size_t c = 0; c < a.angles.size(); ++c)
        CHECK(b.angles[c] == Approx(a.angles[c]).margin(1e-6));
      CHECK(a.active == b.active);
    }
}

TEST_CASE("a higher floor keeps the smallest angle larger") {
  const AngleProblem problem = problemOf(cone(12, 4), 1);
  double last = 0;
  for (double floor : {1e-6, 1e-2, 1.0}) {
    const AngleSolution s = byInteriorPoint(problem, floor);
    REQUIRE(s.converged);
    CHECK(s.barrierFloor == floor);
    const double least = *std::min_element(s.angles.begin(), s.angles.end());
    CHECK(least >= last);
    last = least;
  }
}

TEST_CASE("where no angles meet all bounds, the interior point soon ends") {
  // All angles of an outline of n vertices sum to (n - 2) pi.
  for (double t : {0.3, 0.6, 0.9}) {
    const AngleSolution s = byInteriorPoint(problemOf(bumpyGrid(8, 7, 0.35, 1), t), 1e-2);
    CHECK_FALSE(s.converged);
    CHECK(s.history.size() < 100);
  }
}

TEST_CASE("charts whose angles want to be 0 are solved by the interior point") {
  for (const char* file : {"camel-cut.obj", "cow-cut.off"}) {
    const PolygonMesh mesh = sharedMesh(file);
    if (mesh.faceCount() == 0) return;
    const AngleProblem problem = problemOf(mesh, 1);
    const AngleSolution s = byInteriorPoint(problem, kDefaultBarrierFloor);
    CHECK(s.converged);
    CHECK(s.constraintResidual <= 1e-10);
  }
}
