#include "solve/conjugate_gradients.h"

#include <Eigen/Core>
#include <algorithm>
#include <random>

#include "catch.h"
#include "solve/cholesky/cholesky.h"
#include "solve/cholesky/matrices.h"
#include "solve/row_solver.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

using Code = ConjugateGradientsResult::Code;

/// The inverse of the diagonal.
class Jacobi : public Preconditioner {
 public:
  explicit Jacobi(const SparseMatrix& m) : inverse_(Eigen::VectorXd(m.diagonal()).cwiseInverse()) {}
  void apply(const double* r, double* z) const override {
    for (Eigen::Index i = 0; i < inverse_.size(); ++i) z[i] = inverse_[i] * r[i];
  }

 private:
  Eigen::VectorXd inverse_;
};

Eigen::VectorXd randomVector(Eigen::Index n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  Eigen::VectorXd x(n);
  for (double& entry : x) entry = value(random);
  return x;
}

SparseMatrix gridMatrix(double shift = 0.01) {
  return meshLaplacian(bumpyGrid(25, 20, 0.3, 4), shift);
}

double largestResidual(const SparseMatrix& m, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
  return (b - m.selfadjointView<Eigen::Lower>() * x).lpNorm<Eigen::Infinity>();
}

}  // namespace

TEST_CASE("conjugate gradients reach the tolerance from any guess") {
  const SparseMatrix m = gridMatrix();
  const Eigen::VectorXd b = randomVector(m.rows(), 1);
  int before = 0;
  for (const double tolerance : {1e-2, 1e-5, 1e-10}) {
    for (const bool isGuessed : {false, true}) {
      Eigen::VectorXd x = isGuessed ? randomVector(m.rows(), 2) : Eigen::VectorXd::Zero(m.rows());
      const ConjugateGradientsResult r = conjugateGradients(m, b, Jacobi(m), x, {tolerance});
      CHECK(r.isConverged());
      CHECK(r.residual <= tolerance);
      CHECK(largestResidual(m, x, b) <= 1.01 * tolerance);
      if (!isGuessed) {
        CHECK(r.iterations > before);
        before = r.iterations;
      }
    }
  }
}

TEST_CASE("conjugate gradients need nothing where the guess is the solution") {
  const SparseMatrix m = gridMatrix();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(m.rows());
  CHECK(conjugateGradients(m, Eigen::VectorXd::Zero(m.rows()), Jacobi(m), x).iterations == 0);
  CHECK(x.isZero(0));
  SparseMatrix empty(0, 0);
  Eigen::VectorXd nothing(0);
  CHECK(conjugateGradients(empty, nothing, Jacobi(empty), nothing).isConverged());
}

TEST_CASE("conjugate gradients say why they end") {
  SparseMatrix m = gridMatrix(1e-6);
  const Eigen::VectorXd b = randomVector(m.rows(), 1);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(m.rows());
  ConjugateGradientsResult r = conjugateGradients(m, b, Jacobi(m), x, {1e-12, 5});
  CHECK(r.code == Code::TooManyIterations);
  CHECK(r.iterations == 5);
  CHECK(largestResidual(m, x, b) == Approx(r.residual));
  x.setZero();
  r = conjugateGradients(m, b, Jacobi(m), x, {1e-12, 1000, 6});
  CHECK(r.code == Code::TooSlow);
  CHECK(r.iterations < 1000);
  m.coeffRef(77, 77) = -3;
  x.setZero();
  r = conjugateGradients(m, b, Jacobi(gridMatrix()), x, {1e-12, 1000});
  CHECK(r.code == Code::NotPositive);
  CHECK(x.allFinite());
}

TEST_CASE("an inexact row solver reaches the tolerance whatever the matrices do") {
  SparseMatrix m = withTwoRowsEach(gridMatrix());
  const Eigen::VectorXd b = randomVector(m.rows(), 1);
  const auto solver = makeInexactRowSolver(m, nullptr);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> factor(0.5, 2);
  const auto check = [&](double tolerance) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(m.rows());
    REQUIRE(solver->solve(m, b, tolerance, x));
    CHECK(largestResidual(m, x, b) <= std::max(1.1 * tolerance, 1e-12));
  };
  check(1e-8);
  CHECK(solver->iterations() <= 4);
  check(1e-8);  // the same matrix, which has a factor
  CHECK(solver->iterations() <= 4);
  for (double& value : Eigen::Map<Eigen::VectorXd>(m.valuePtr(), m.nonZeros())) value *= 3;
  check(1e-8);  // only scaled: the factor still works
  CHECK(solver->iterations() <= 4);
  for (Eigen::Index c = 0; c < m.rows(); ++c) m.coeffRef(c, c) *= 1 + 1000 * factor(random);
  check(1e-8);  // another matrix
  m.coeffRef(50, 50) *= -1;
  check(1e-8);  // indefinite: solved directly
  m.coeffRef(50, 50) *= -1;
  check(1e-8);
  CHECK(solver->iterations() > 0);
  check(0);
  CHECK(solver->iterations() == 0);
  m.coeffRef(50, 50) = std::numeric_limits<double>::quiet_NaN();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(m.rows());
  CHECK_FALSE(solver->solve(m, b, 1e-8, x));
}
