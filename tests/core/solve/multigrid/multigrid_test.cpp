#include "solve/multigrid/multigrid.h"

#include <cmath>

#include "catch.h"
#include "solve/conjugate_gradients.h"
#include "solve/multigrid/aggregation.h"
#include "solve/multigrid/galerkin.h"
#include "solve/schur_system.h"
#include "support/dense_algebra.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

HalfMatrix halfOf(const SparseMatrix& lower) {
  return {static_cast<std::uint32_t>(lower.rows()), lower.outerIndexPtr(), lower.innerIndexPtr(),
          lower.valuePtr()};
}

/// The system of the first Newton step. With t = 1, boundary vertices with too large angles are
/// active.
struct NewtonMatrix {
  SparseMatrix lower;
  Eigen::VectorXd rhs;
  std::vector<std::uint8_t> kind;

  NewtonMatrix(const PolygonMesh& mesh, double t) {
    const AngleProblem problem = problemOf(mesh, t);
    const ConstraintRows rows = numberRows(problem);
    SchurSystem schur(problem, rows);
    Linearization lin;
    const std::vector<double> none(rows.count(), 0.0);
    linearize(problem, rows, {problem.target.raw(), none, Curvature::Clamped}, lin);
    std::vector<std::uint8_t> active(problem.vertexCount());
    for (const ChartVertex v : problem.vertices())
      active[v] = problem.isBoundary[v] && lin.residual[rows.ofVertex[v]] > 0;
    schur.assemble(lin, active);
    lower = schur.matrix();
    rhs = schur.rightHandSide();
    kind = rowKinds(rows);
  }
};

Eigen::MatrixXd denseOf(const Preconditioner& m, Eigen::Index n) {
  Eigen::MatrixXd dense(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(n, j);
    m.apply(unit.data(), dense.col(j).data());
  }
  return dense;
}

/// Iterations needed to reduce the residual by 1e-10.
int iterations(const NewtonMatrix& newton, const Preconditioner& m) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(newton.rhs.size());
  ConjugateGradientsOptions options;
  options.tolerance = 1e-10 * newton.rhs.lpNorm<Eigen::Infinity>();
  options.maxIterations = 200;
  const ConjugateGradientsResult result =
      conjugateGradients(newton.lower, newton.rhs, m, x, options);
  CHECK(result.isConverged());
  const Eigen::VectorXd left =
      newton.rhs - Eigen::VectorXd(newton.lower.selfadjointView<Eigen::Lower>() * x);
  CHECK(left.lpNorm<Eigen::Infinity>() <= 2 * options.tolerance);
  return result.iterations;
}

int iterations(const PolygonMesh& mesh, double t) {
  const NewtonMatrix newton(mesh, t);
  Multigrid m(newton.kind);
  REQUIRE(m.setup(halfOf(newton.lower)));
  return iterations(newton, m);
}

/// Stretched, so that all triangles are needles.
PolygonMesh needles(double aspect) {
  PolygonMesh mesh = bumpyGrid(60, 60, 0.2, 5);
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) mesh.positions[i] *= aspect;
  return mesh;
}

}  // namespace

TEST_CASE("the Galerkin product is P' A P") {
  const NewtonMatrix newton(bumpyGrid(12, 9, 0.3, 1), 1);
  const HalfMatrix a = halfOf(newton.lower);
  const StrongGraph graph = strongGraph(a, newton.kind, 0.25);
  const Aggregates aggregates = aggregate(graph, newton.kind);
  const CompressedRows p = smoothedProlongation(graph, aggregates);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(a.rows, aggregates.count());
  for (std::uint32_t i = 0; i < a.rows; ++i)
    p.forEach(i, [&](std::uint32_t j, double value) { dense(i, j) = value; });
  const Eigen::MatrixXd full = SparseMatrix(newton.lower.selfadjointView<Eigen::Lower>());
  const Eigen::MatrixXd expected = dense.transpose() * full * dense;
  const CompressedRows coarse = galerkinProduct(a, p, aggregates.count());
  Eigen::MatrixXd actual = Eigen::MatrixXd::Zero(aggregates.count(), aggregates.count());
  for (std::uint32_t i = 0; i < coarse.rows(); ++i) {
    CHECK(coarse.column[coarse.start[i]] == static_cast<int>(i));
    coarse.forEach(i, [&](std::uint32_t j, double value) { actual(i, j) = actual(j, i) = value; });
  }
  CHECK((actual - expected).norm() < 1e-13 * expected.norm());
}

TEST_CASE("aggregates hold rows of one kind, and their prolongation keeps constants inside") {
  const PolygonMesh mesh = bumpyGrid(20, 20, 0.3, 2);
  const NewtonMatrix newton(mesh, 2);
  const StrongGraph graph = strongGraph(halfOf(newton.lower), newton.kind, 0.25);
  const Aggregates aggregates = aggregate(graph, newton.kind);
  const CompressedRows p = smoothedProlongation(graph, aggregates);
  CHECK(4 * aggregates.count() < newton.kind.size());
  std::uint32_t constant = 0;
  for (std::uint32_t i = 0; i < p.rows(); ++i) {
    const std::uint32_t own = aggregates.ofRow[i];
    if (own != kNoAggregate) CHECK(aggregates.kind[own] == newton.kind[i]);
    double sum = 0;
    p.forEach(i, [&](std::uint32_t j, double value) {
      CHECK(aggregates.kind[j] == newton.kind[i]);
      sum += value;
    });
    constant += std::abs(sum - 1) < 1e-9;
  }
  // All rows whose neighbours are inside as well: 17 * 17 vertices.
  CHECK(constant >= 2 * 17 * 17);
}

TEST_CASE("a multigrid cycle is symmetric positive definite") {
  for (const double t : {1.0, 2.0})
    for (const std::uint32_t coarsest : {0u, 30u, 1500u}) {
      const NewtonMatrix newton(bumpyGrid(14, 11, 0.4, 3), t);
      MultigridOptions options;
      options.coarsestRows = coarsest;
      Multigrid m(newton.kind, options);
      REQUIRE(m.setup(halfOf(newton.lower)));
      CHECK((m.levels() > 1) == (coarsest < 1500));
      const Eigen::MatrixXd dense = denseOf(m, newton.rhs.size());
      CHECK((dense - dense.transpose()).norm() < 1e-12 * dense.norm());
      CHECK(symmetricEigen(dense).values[0] > 0);
      CHECK(denseOf(m, newton.rhs.size()) == dense);
    }
}

TEST_CASE("iterations hardly grow with the size") {
  for (const double t : {1.0, 2.0}) {
    CHECK(iterations(bumpyGrid(40, 40, 0.3, 4), t) <= 25);
    CHECK(iterations(bumpyGrid(80, 80, 0.3, 4), t) <= 30);
    CHECK(iterations(bumpyGrid(160, 160, 0.3, 4), t) <= 35);
  }
}

TEST_CASE("multigrid converges on needle triangles") {
  for (const double aspect : {1e2, 1e4}) CHECK(iterations(needles(aspect), 2) <= 150);
}

TEST_CASE("multigrid converges on every shared mesh") {
  for (const char* file :
       {"body.off", "camel-cut.obj", "cathead.obj", "cow-cut.off", "face.obj", "hemisphere.obj",
        "mannequin.off", "nefertiti.off", "nonconvex-cap.off"}) {
    const PolygonMesh mesh = sharedMesh(file);
    if (mesh.faceCount() == 0) return;
    if (!buildSurface(mesh).summary.disk.ok()) continue;
    for (const double t : {1.0, 2.0}) {
      INFO(file << " t = " << t);
      CHECK(iterations(mesh, t) <= 60);
    }
  }
}

TEST_CASE("multigrid takes no more than a few times the memory of the matrix") {
  const NewtonMatrix newton(bumpyGrid(150, 150, 0.3, 6), 2);
  Multigrid m(newton.kind);
  REQUIRE(m.setup(halfOf(newton.lower)));
  const auto matrix = static_cast<std::uint64_t>(12 * newton.lower.nonZeros());
  CHECK(m.bytes() > 8 * static_cast<std::uint64_t>(newton.rhs.size()));
  CHECK(m.bytes() < 2 * matrix);
  CHECK(m.complexity() < 1.6);
  const CholeskySymbolic direct =
      analyzePattern({static_cast<std::uint32_t>(newton.lower.rows()), newton.lower.outerIndexPtr(),
                      newton.lower.innerIndexPtr()});
  CHECK(3 * m.bytes() < direct.factorBytes());
}

TEST_CASE("a matrix that is not positive definite is noticed") {
  NewtonMatrix newton(bumpyGrid(50, 50, 0.3, 7), 2);
  Multigrid m(newton.kind);
  SECTION("a diagonal entry of 0") {
    newton.lower.valuePtr()[newton.lower.outerIndexPtr()[100]] = 0;
    CHECK_FALSE(m.setup(halfOf(newton.lower)));
  }
  SECTION("negative in a smooth direction") {
    for (int i = 0; i < newton.lower.rows(); ++i)
      newton.lower.valuePtr()[newton.lower.outerIndexPtr()[i]] *= 0.9;
    if (!m.setup(halfOf(newton.lower))) return;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(newton.rhs.size());
    const ConjugateGradientsResult result = conjugateGradients(newton.lower, newton.rhs, m, x);
    CHECK(result.code == ConjugateGradientsResult::Code::NotPositive);
  }
  SECTION("not a number") {
    newton.lower.valuePtr()[newton.lower.outerIndexPtr()[100]] = std::nan("");
    CHECK_FALSE(m.setup(halfOf(newton.lower)));
  }
}
