#include "solve/element.h"

#include "catch.h"
#include "solve/linearization.h"
#include "solve/schur_system.h"
#include "support/dense_algebra.h"
#include "support/dense_kkt.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Dense KKT matrix of eq. (8) from finite differences, with the elements' diagonal Hessian.
Eigen::MatrixXd denseKkt(const DenseProblem& dense, const Linearization& lin,
                         const Eigen::VectorXd& x, const std::vector<Eigen::Index>& used) {
  const Eigen::MatrixXd j = dense.jacobian(x);
  const auto m = static_cast<Eigen::Index>(used.size());
  Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(x.size() + m, x.size() + m);
  for (Eigen::Index c = 0; c < x.size(); ++c)
    kkt(c, c) =
        lin.elements[static_cast<std::size_t>(c / 3)].hessian[static_cast<std::size_t>(c % 3)];
  for (Eigen::Index i = 0; i < m; ++i) {
    kkt.row(x.size() + i).head(x.size()) = j.row(used[static_cast<std::size_t>(i)]);
    kkt.col(x.size() + i).head(x.size()) = j.row(used[static_cast<std::size_t>(i)]).transpose();
  }
  return kkt;
}

Eigen::VectorXd toEigen(const std::vector<double>& v) {
  return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
}

Eigen::VectorXd allMultipliers(const Multipliers& m) {
  Eigen::VectorXd all(m.triangle.size() + m.row.size());
  all << toEigen(m.triangle), toEigen(m.row);
  return all;
}

struct Case {
  AngleProblem problem;
  ConstraintRows rows;
  RandomPoint point;
  Linearization lin;
  DenseProblem dense;

  Case(const PolygonMesh& mesh, double t, unsigned seed, Curvature curvature = Curvature::Clamped)
      : problem(problemOf(mesh, t)),
        rows(numberRows(problem)),
        point(problem, rows, seed),
        dense{problem, rows} {
    linearize(problem, rows, {point.x, point.multipliers.row, curvature}, lin);
  }
};

}  // namespace

TEST_CASE("residuals and objective match the constraints written one by one") {
  for (unsigned seed : {1u, 2u}) {
    const Case k(bumpyGrid(4, 3, 0.4, seed), 1.1, seed);
    const Eigen::VectorXd h = k.dense.constraints(toEigen(k.point.x));
    for (const ChartTriangle f : k.problem.triangles())
      CHECK(k.lin.elements[f].triangleResidual == Approx(h[f]).margin(1e-13));
    for (std::uint32_t r = 0; r < k.rows.count(); ++r)
      CHECK(k.lin.residual[r] == Approx(h[k.problem.triangleCount() + r]).margin(1e-13));
    CHECK(k.lin.objective == Approx(k.dense.objective(toEigen(k.point.x))));
  }
}

TEST_CASE("constraint Jacobians match central differences") {
  const Case k(bumpyGrid(4, 3, 0.4, 3), 1.1, 3);
  const Eigen::MatrixXd j = k.dense.jacobian(toEigen(k.point.x)).bottomRows(k.rows.count());
  Eigen::MatrixXd assembled = Eigen::MatrixXd::Zero(j.rows(), j.cols());
  for (const ChartTriangle f : k.problem.triangles())
    for (std::uint32_t c = 0; c < 3; ++c) {
      std::array<double, 3> unit{0, 0, 0};
      unit[c] = 1;
      const std::array<double, 6> y = applyJacobian(k.lin.elements[f], unit);
      for (std::uint32_t i = 0; i < 3; ++i) {
        const ChartVertex v = k.problem.vertexOfCorner[cornerOf(f, i)];
        assembled(k.rows.ofVertex[v], 3 * f + c) += y[2 * i];
        if (!k.problem.isBoundary[v]) assembled(k.rows.ofVertex[v] + 1, 3 * f + c) += y[2 * i + 1];
      }
    }
  CHECK((assembled - j).cwiseAbs().maxCoeff() < 1e-7);
}

TEST_CASE("the transposed Jacobian is the adjoint of the Jacobian") {
  const Case k(bumpyGrid(2, 2, 0.4, 4), 1, 4);
  const std::array<double, 6> y{0.3, -1.2, 0.7, 0.1, -0.4, 2};
  const std::array<double, 3> z{0.9, -0.2, 0.5};
  for (const Element& e : k.lin.elements) {
    const std::array<double, 6> bz = applyJacobian(e, z);
    const std::array<double, 3> bty = applyTransposedJacobian(e, y);
    double left = 0, right = 0;
    for (std::size_t i = 0; i < 6; ++i) left += bz[i] * y[i];
    for (std::size_t i = 0; i < 3; ++i) right += bty[i] * z[i];
    CHECK(left == Approx(right));
  }
}

TEST_CASE("gradient and diagonal Hessian of the Lagrangian match central differences") {
  const Case k(bumpyGrid(4, 3, 0.3, 5), 1.1, 5, Curvature::Exact);
  const Eigen::VectorXd x = toEigen(k.point.x), m = allMultipliers(k.point.multipliers);
  const Eigen::VectorXd g = k.dense.gradient(x, m);
  double worst = 0;
  for (const ChartTriangle f : k.problem.triangles()) {
    const Element& e = k.lin.elements[f];
    const auto z =
        applyTransposedJacobian(e, gatherRows(k.problem, k.rows, k.point.multipliers.row, f));
    for (std::uint32_t c = 0; c < 3; ++c) {
      const double analytic = e.gradient[c] + z[c] + k.point.multipliers.triangle[f];
      CHECK(analytic == Approx(g[3 * f + c]).margin(1e-6));
      worst = std::max(worst, std::abs(analytic) * k.problem.target[cornerOf(f, c)] / 2);
      constexpr double kStep = 1e-5;
      Eigen::VectorXd above = x, below = x;
      above[3 * f + c] += kStep;
      below[3 * f + c] -= kStep;
      const double curvature =
          (k.dense.gradient(above, m)[3 * f + c] - k.dense.gradient(below, m)[3 * f + c]) /
          (2 * kStep);
      CHECK(e.hessian[c] == Approx(curvature).epsilon(1e-3));
    }
  }
  CHECK(gradientResidual(k.problem, k.rows, k.lin, k.point.multipliers) == Approx(worst));
}

TEST_CASE("element matrices are B P B^T of the explicit matrices and semidefinite") {
  const Case k(bumpyGrid(3, 3, 0.5, 6), 1, 6);
  for (const Element& e : k.lin.elements) {
    Eigen::Matrix<double, 6, 3> b;
    for (unsigned c = 0; c < 3; ++c) {
      std::array<double, 3> unit{0, 0, 0};
      unit[c] = 1;
      const auto y = applyJacobian(e, unit);
      for (unsigned r = 0; r < 6; ++r) b(r, c) = y[r];
    }
    const Eigen::Vector3d d(1 / e.hessian[0], 1 / e.hessian[1], 1 / e.hessian[2]);
    const Eigen::Matrix3d p = Eigen::Matrix3d(d.asDiagonal()) - d * d.transpose() / d.sum();
    const Eigen::Matrix<double, 6, 6> wanted = b * p * b.transpose();
    const auto m = elementMatrix(e);
    unsigned i = 0;
    for (unsigned r = 0; r < 6; ++r)
      for (unsigned c = 0; c <= r; ++c) CHECK(m[i++] == Approx(wanted(r, c)).margin(1e-12));
    CHECK(symmetricEigen(wanted).values[0] > -1e-12 * wanted.norm());
  }
}

TEST_CASE("the Schur step equals the step of the full KKT system") {
  for (unsigned seed : {7u, 8u, 9u}) {
    const Case k(bumpyGrid(5, 4, 0.4, seed), 1, seed);
    std::mt19937 random(seed);
    std::vector<std::uint8_t> active(k.problem.vertexCount(), 0);
    std::vector<Eigen::Index> used;
    for (Eigen::Index f = 0; f < k.problem.triangleCount(); ++f) used.push_back(f);
    for (const ChartVertex v : k.problem.vertices()) {
      active[v] = k.problem.isBoundary[v] && random() % 3 == 0;
      if (k.problem.isBoundary[v] && !active[v]) continue;
      for (std::uint32_t r = k.rows.ofVertex[v]; r < k.rows.ofVertex[v + 1]; ++r)
        used.push_back(k.problem.triangleCount() + r);
    }
    const Eigen::VectorXd x = toEigen(k.point.x), h = k.dense.constraints(x);
    Eigen::VectorXd rhs(x.size() + static_cast<Eigen::Index>(used.size()));
    for (Eigen::Index c = 0; c < x.size(); ++c)
      rhs[c] = -k.lin.elements[static_cast<std::size_t>(c / 3)]
                    .gradient[static_cast<std::size_t>(c % 3)];
    for (std::size_t i = 0; i < used.size(); ++i)
      rhs[x.size() + static_cast<Eigen::Index>(i)] = -h[used[i]];
    const Eigen::VectorXd wanted = denseSolve(denseKkt(k.dense, k.lin, x, used), rhs);

    SchurSystem system(k.problem, k.rows);
    system.assemble(k.lin, active);
    const Eigen::MatrixXd full = Eigen::MatrixXd(system.matrix()).selfadjointView<Eigen::Lower>();
    const Eigen::VectorXd solved = denseSolve(full, system.rightHandSide());
    std::vector<double> dx, triangle;
    system.backSubstitute(k.lin, {solved.begin(), solved.end()}, dx, triangle);
    CHECK((toEigen(dx) - wanted.head(x.size())).cwiseAbs().maxCoeff() < 1e-7);
    for (std::size_t i = 0; i < used.size(); ++i) {
      const Eigen::Index r = used[i] - k.problem.triangleCount();
      const double got = r < 0 ? triangle[i] : solved[r];
      CHECK(got ==
            Approx(wanted[x.size() + static_cast<Eigen::Index>(i)]).epsilon(1e-5).margin(1e-6));
    }
  }
}
