#include "solve/newton_system.h"

#include <cmath>

#include "catch.h"
#include "solve/active_set.h"
#include "support/instrumented.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Largest difference of the angles from those with Eigen's factorisation; either both converge or
/// neither.
double difference(const AngleProblem& problem, MakeRowSolver& makeSolver) {
  SolverOptions options;
  options.maxSteps = 30;
  NewtonSystem own(problem, makeSolver), eigen(problem, makeEigenRowSolver);
  const AngleSolution a = solveActiveSet(problem, own, options);
  const AngleSolution b = solveActiveSet(problem, eigen, options);
  CHECK(a.converged == b.converged);
  double worst = 0;
  if (a.converged)
    for (std::size_t c = 0; c < a.angles.size(); ++c)
      worst = std::max(worst, std::abs(a.angles[c] - b.angles[c]));
  return worst;
}

/// Inexact steps end a little further from the optimum, within the stopping rules.
void checkAll(const AngleProblem& problem) {
  CHECK(difference(problem, makeRowSolver) < 1e-9);
  CHECK(difference(problem, makeDirectRowSolver) < 1e-9);
  CHECK(difference(problem, makeInexactRowSolver) < 1e-8);
}

/// On the shared disks of more than `over` and at most `most` faces; returns how many there are.
int checkSharedDisks(std::size_t over, std::size_t most) {
  int disks = 0;
  for (const char* file :
       {"beetle-nonmanifold.obj", "body.off", "bunny-closed.off", "camel-cut.obj", "cathead.obj",
        "cow-cut.off", "face.obj", "fertility-genus4.off", "genus3.off", "halftunnel-quads.off",
        "hemisphere.obj", "inspired.obj", "mannequin.off", "nefertiti.off", "nonconvex-cap.off",
        "spot-uv.obj", "suzanne-quads.obj", "teapot-5parts.obj", "woody.obj"}) {
    const PolygonMesh mesh = sharedMesh(file);
    if (mesh.faceCount() <= over || mesh.faceCount() > most) continue;
    const Surface surface = buildSurface(mesh);
    if (!surface.summary.disk.ok()) continue;
    ++disks;
    const DiskChart chart = makeDiskChart(mesh, surface);
    for (const double t : {1.0, 2.0}) {
      INFO(file << " t = " << t);
      checkAll(problemOf(chart, t));
    }
  }
  return disks;
}

constexpr std::size_t kUsualFaces = 10000;

}  // namespace

TEST_CASE("all factorisations lead to the same angles on generated disks") {
  for (const PolygonMesh& mesh : {bumpyGrid(1, 1, 0.2, 1), bumpyGrid(9, 7, 0.4, 2),
                                  bumpyGrid(cases(60u, 20u), 45, 0.3, 3), cone(7, 1)})
    for (const double t : {0.98, 2.0}) checkAll(problemOf(mesh, t));
}

TEST_CASE("all factorisations lead to the same angles on shared disks of usual size") {
  if (sharedMesh("face.obj").faceCount() == 0) return;
  CHECK(checkSharedDisks(0, cases<std::size_t>(kUsualFaces, 2000)) >= cases(6, 4));
}

TEST_CASE("all factorisations lead to the same angles on the largest shared disks", "[.long]") {
  if (sharedMesh("face.obj").faceCount() == 0) return;
  CHECK(checkSharedDisks(kUsualFaces, 100000) >= 1);
}
