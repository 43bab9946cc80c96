#include "refine/refine.h"

#include <cmath>

#include "catch.h"
#include "refine/boundary_barrier.h"
#include "refine/layout_energy.h"
#include "support/dense_algebra.h"
#include "support/instrumented.h"
#include "support/meshes.h"
#include "support/problems.h"
#include "support/refined.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Largest difference of edge lengths, relative to those of `a`.
double lengthDifference(const DiskChart& chart, const std::vector<double>& a,
                        const std::vector<double>& b) {
  double most = 0;
  for (const ChartCorner h : chart.corners()) {
    const std::size_t p = 2 * chart.vertexOfCorner[h], q = 2 * chart.vertexOfCorner[nextCorner(h)];
    const double x = std::hypot(a[p] - a[q], a[p + 1] - a[q + 1]);
    const double y = std::hypot(b[p] - b[q], b[p + 1] - b[q + 1]);
    most = std::max(most, std::abs(x - y) / x);
  }
  return most;
}

/// A sheet rolled up along a curve, which can be flattened without distortion.
PolygonMesh rolledSheet() {
  PolygonMesh mesh = bumpyGrid(12, 8, 0, 4);
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    double* p = &mesh.positions[3 * v];
    const double angle = p[0] / 4;
    p[0] = 4 * std::sin(angle);
    p[2] = 4 - 4 * std::cos(angle);
  }
  return mesh;
}

}  // namespace

TEST_CASE("gradient and matrix of a layout agree with differences of its energy", "[refine]") {
  const DiskChart chart = chartOf(bumpyGrid(4, 3, 0.6, 9));
  const std::vector<double> uv = conformalLayout(chart);
  const RestTriangles rest = restTriangles(chart, uv);
  RowSystem system = layoutRows(chart);
  for (const Energy& energy : {Energy(0), Energy(0.2), Energy(1)}) {
    assembleDerivatives(chart, rest, {uv, energy}, {}, system);
    const Eigen::MatrixXd matrix = Eigen::MatrixXd(system.matrix()).selfadjointView<Eigen::Lower>();
    CHECK(symmetricEigen(matrix).values[0] > -1e-9);
    constexpr double kStep = 1e-6;
    for (std::size_t i = 0; i < uv.size(); ++i) {
      std::vector<double> up = uv, down = uv;
      up[i] += kStep;
      down[i] -= kStep;
      const double slope =
          (layoutEnergy(chart, rest, energy, up) - layoutEnergy(chart, rest, energy, down)) /
          (2 * kStep);
      CHECK(system.rightHandSide[static_cast<Eigen::Index>(i)] == Approx(slope).margin(1e-7));
    }
    // Moving everything changes nothing.
    Eigen::VectorXd shift = Eigen::VectorXd::Zero(matrix.rows());
    for (Eigen::Index i = 0; i < shift.size(); i += 2) shift[i] = 1;
    CHECK((matrix * shift).cwiseAbs().maxCoeff() < 1e-9);
  }
}

TEST_CASE("no other scale has less energy than the best one", "[refine]") {
  const DiskChart chart = chartOf(bumpyGrid(6, 5, 0.7, 4));
  const std::vector<double> uv = conformalLayout(chart);
  const RestTriangles rest = restTriangles(chart, uv);
  for (const Energy& energy : {Energy(0), Energy(0.2), Energy(1)}) {
    const auto at = [&](double scale) {
      std::vector<double> scaled = uv;
      for (double& x : scaled) x *= scale;
      return layoutEnergy(chart, rest, energy, scaled);
    };
    const double best = bestScale(chart, rest, energy, uv);
    for (const double other : {0.5, 0.99, 1.01, 2.0}) CHECK(at(best) <= at(other * best) + 1e-12);
  }
}

TEST_CASE("a sheet that is only bent becomes flat without distortion", "[refine]") {
  const PolygonMesh mesh = rolledSheet();
  const DiskChart chart = chartOf(mesh);
  std::vector<double> uv = conformalLayout(chart);
  for (std::size_t i = 0; i < uv.size(); i += 2) uv[i] *= 1.5;
  const Refinement r = refine(chart, uv, withBalance(1));
  CHECK(r.isConverged);
  CHECK(r.energyBefore > 1.01);
  CHECK(r.energy == Approx(1).epsilon(1e-4));
}

TEST_CASE("refining takes energy away and flips nothing", "[refine]") {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const DiskChart chart = chartOf(bumpyGrid(9 + seed, 14, 0.15 * (seed + 1), seed));
    const std::vector<double> uv = conformalLayout(chart);
    for (const double balance : {0.05, 0.3, 1.0}) {
      const Refinement r = refine(chart, uv, withBalance(balance));
      CAPTURE(seed, balance, r.steps);
      CHECK(r.isConverged);
      CHECK(r.energy < r.energyBefore);
      CHECK(r.energy >= 1);
      CHECK(checkValidity(chart, r.uv).valid());
      CHECK(r.energy ==
            Approx(layoutEnergy(chart, restTriangles(chart, uv), Energy(balance), r.uv)));
      // The second time there is nothing left to gain.
      const Refinement again = refine(chart, r.uv, withBalance(balance));
      CHECK(again.energyBefore - again.energy <= 2e-3 * (r.energyBefore - 1));
    }
  }
}

TEST_CASE("what rough angles are refined to is as good, after fewer steps", "[refine]") {
  int fewer = 0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    const DiskChart chart = chartOf(bumpyGrid(9 + seed, 14, 0.2 * (seed + 1), seed));
    const BoundaryBounds free(chart.boundary.size(), 2);
    ChartFlattener flattener(chart, {});
    const Attempt rough = flattener.attempt(free, nullptr, Exactness::Rough);
    const Attempt exact = flattener.attempt(free, nullptr);
    REQUIRE(rough.valid());
    CAPTURE(seed);
    CHECK(rough.solution.constraintResidual <= 1e-3);
    CHECK(exact.solution.constraintResidual <= 1e-10);
    CHECK(rough.solution.history.size() <= exact.solution.history.size());
    fewer += rough.solution.history.size() < exact.solution.history.size();
    const double a = refine(chart, rough.uv, withBalance(0.2)).energy;
    const double b = refine(chart, exact.uv, withBalance(0.2)).energy;
    CHECK(a - 1 == Approx(b - 1).epsilon(5e-3));
  }
  CHECK(fewer == 8);
}

TEST_CASE("hundreds of disks stay valid at any balance", "[refine]") {
  for (unsigned seed = 0; seed < cases(300u, 20u); ++seed) {
    const DiskChart chart =
        chartOf(bumpyGrid(3 + seed % 7, 4 + seed % 5, 0.05 * (seed % 29), seed));
    const std::vector<double> uv = conformalLayout(chart);
    for (const double balance : {0.0, 0.25, 0.5, 1.0}) {
      const Refinement r = refine(chart, uv, withBalance(balance));
      CAPTURE(seed, balance, r.steps, r.energyBefore, r.energy);
      CHECK(checkSeparated(chart, r.uv).valid());
      CHECK(r.energy <= r.energyBefore);
      CHECK(r.energy >= 1 - 1e-12);
    }
  }
}

TEST_CASE("refining depends neither on the unit, nor on numbers, nor on where the layout lies",
          "[refine]") {
  const PolygonMesh mesh = bumpyGrid(15, 11, 0.8, 2);
  const DiskChart chart = chartOf(mesh);
  const std::vector<double> uv = conformalLayout(chart);
  RefineOptions options = withBalance(0.3);
  options.tolerance = 1e-9;
  const Refinement wanted = refine(chart, uv, options);
  std::vector<double> turned;
  for (std::size_t i = 0; i < uv.size(); i += 2)
    turned.insert(turned.end(), {3 * (0.6 * uv[i] - 0.8 * uv[i + 1]) + 5,
                                 3 * (0.8 * uv[i] + 0.6 * uv[i + 1]) - 2});
  CHECK(lengthDifference(chart, wanted.uv, refine(chart, turned, options).uv) < 1e-4);

  const Renumbered other = renumbered(mesh, 8);
  const DiskChart renamed = chartOf(other.mesh);
  std::vector<double> moved(uv.size());
  std::vector<std::uint32_t> ofInput(mesh.vertexCount());
  for (const ChartVertex v : renamed.vertices()) ofInput[renamed.inputVertex[v]] = v;
  const auto now = [&](ChartVertex v) { return ofInput[other.vertex[chart.inputVertex[v]]]; };
  for (const ChartVertex v : chart.vertices())
    for (std::size_t d = 0; d < 2; ++d) moved[2 * std::size_t{now(v)} + d] = uv[2 * v + d];
  const Refinement found = refine(renamed, moved, options);
  std::vector<double> back(uv.size());
  for (const ChartVertex v : chart.vertices())
    for (std::size_t d = 0; d < 2; ++d) back[2 * v + d] = found.uv[2 * std::size_t{now(v)} + d];
  CHECK(lengthDifference(chart, wanted.uv, back) < 1e-4);
  CHECK(found.energy == Approx(wanted.energy).epsilon(1e-8));
}

TEST_CASE("refining does not depend on threads", "[refine]") {
  // Large enough for everything that is divided among threads.
  const DiskChart chart = chartOf(bumpyGrid(140, 130, 0.7, 3));
  const std::vector<double> uv = conformalLayout(chart);
  RefineOptions options = withBalance(0.5);
  const Refinement one = refine(chart, uv, options);
  ThreadPool pool(2);
  options.pool = &pool;
  const Refinement two = refine(chart, uv, options);
  CHECK(one.uv == two.uv);
  CHECK(one.energy == two.energy);
  CHECK(one.steps == two.steps);
}

TEST_CASE("vertices that are fixed stay where they are", "[refine]") {
  const DiskChart chart = chartOf(bumpyGrid(12, 12, 0.7, 6));
  const std::vector<double> uv = conformalLayout(chart);
  RefineOptions options = withBalance(0.5);
  options.isFixed.assign(chart.vertexCount(), 0);
  for (const ChartCorner h : chart.boundary) options.isFixed[chart.vertexOfCorner[h]] = 1;
  const Refinement r = refine(chart, uv, options);
  CHECK(r.energy < r.energyBefore);
  for (const ChartVertex v : chart.vertices())
    if (options.isFixed[v]) {
      CHECK(r.uv[2 * v] == uv[2 * v]);
      CHECK(r.uv[2 * v + 1] == uv[2 * v + 1]);
    }
}

TEST_CASE("what is fixed gives the scale: a layout of another size keeps its form", "[refine]") {
  const DiskChart chart = chartOf(bumpyGrid(12, 12, 0.7, 6));
  const std::vector<double> uv = conformalLayout(chart);
  RefineOptions options = withBalance(0.5);
  options.isFixed.assign(chart.vertexCount(), 0);
  options.isFixed[ChartVertex(14)] = options.isFixed[ChartVertex(140)] = 1;
  const Refinement r = refine(chart, uv, options);
  CHECK(r.energy < r.energyBefore);
  for (const double scale : {0.125, 8.0}) {
    std::vector<double> scaled = uv;
    for (double& x : scaled) x *= scale;
    const Refinement other = refine(chart, scaled, options);
    CHECK(other.energy == Approx(r.energy));
    for (std::size_t i = 0; i < uv.size(); ++i)
      CHECK(other.uv[i] / scale == Approx(r.uv[i]).margin(1e-6));
  }
}

TEST_CASE("minima of public disks", "[refine]") {
  struct Known {
    const char* file;
    double least, leastDirichlet;
  };
  for (const Known& k :
       {Known{"nefertiti.off", 1.00454, 1.00915}, Known{"cathead.obj", 1.17018, 1.34033},
        Known{"hemisphere.obj", 1.01273, 1.03532}}) {
    const PolygonMesh mesh = sharedMesh(k.file);
    if (mesh.faceCount() == 0) continue;
    const DiskChart chart = chartOf(mesh);
    const std::vector<double> uv = conformalLayout(chart);
    CHECK(refine(chart, uv, withBalance(0.2)).energy == Approx(k.least).epsilon(5e-5));
    CHECK(refine(chart, uv, withBalance(1)).energy == Approx(k.leastDirichlet).epsilon(5e-5));
  }
}

TEST_CASE("derivatives of the barrier agree with differences", "[refine]") {
  const DiskChart chart = chartOf(bumpyGrid(6, 1, 0, 1));
  // A strip bent into a ring whose ends nearly touch.
  std::vector<double> uv;
  for (const ChartVertex v : chart.vertices()) {
    const double turn = (v % 7) / 6.0005, radius = (1 + v / 7) / chart.unit;
    const double angle = turn * 2 * 3.141592653589793;
    uv.insert(uv.end(), {radius * std::sin(angle), -radius * std::cos(angle)});
  }
  const BoundaryBarrier barrier(chart, kContactReach * std::sqrt(surfaceArea(chart)));
  REQUIRE(barrier.energy(uv) > 0);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(uv.size()));
  SparseEntries hessian;
  barrier.addDerivatives(uv, gradient, hessian);
  constexpr double kStep = 1e-8;
  for (std::size_t i = 0; i < uv.size(); ++i) {
    std::vector<double> up = uv, down = uv;
    up[i] += kStep;
    down[i] -= kStep;
    const double slope = (barrier.energy(up) - barrier.energy(down)) / (2 * kStep);
    CHECK(gradient[static_cast<Eigen::Index>(i)] ==
          Approx(slope).epsilon(1e-4).margin(1e-6 * gradient.cwiseAbs().maxCoeff()));
  }
}
