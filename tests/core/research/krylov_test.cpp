#include <random>

#include "catch.h"
#include "research/minres.h"
#include "research/symmlq.h"
#include "support/dense_algebra.h"

using namespace abflat;
using namespace abflat::test;

namespace {

Eigen::MatrixXd randomSymmetric(Eigen::Index n, unsigned seed, double rankLoss = 0) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  Eigen::MatrixXd a(n, n);
  for (Eigen::Index i = 0; i < a.size(); ++i) a.data()[i] = value(random);
  const Eigen::MatrixXd q = orthogonal(a);
  Eigen::VectorXd d(n);
  for (Eigen::Index i = 0; i < n; ++i) d[i] = (i % 2 ? -1 : 1) * (0.5 + std::abs(value(random)));
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(rankLoss); ++i) d[i] = 0;
  return q * d.asDiagonal() * q.transpose();
}

LinearOperator product(const Eigen::MatrixXd& a) {
  return [&a](const Eigen::VectorXd& in, Eigen::VectorXd& out) { out = a * in; };
}

using Method = LinearSolveResult (*)(const LinearOperator&, const Eigen::VectorXd&,
                                     const LinearSolveOptions&, const LinearOperator&);

}  // namespace

TEST_CASE("MINRES and SYMMLQ solve indefinite systems like a dense solver") {
  for (Method method : {Method(minres), Method(symmlq)})
    for (Eigen::Index n : {1, 2, 5, 30, 80})
      for (bool precondition : {false, true}) {
        const Eigen::MatrixXd a = randomSymmetric(n, static_cast<unsigned>(n));
        const Eigen::MatrixXd b = randomSymmetric(n, 99);
        const Eigen::MatrixXd m = b * b + Eigen::MatrixXd::Identity(n, n);
        const Eigen::VectorXd rhs = randomSymmetric(n, 7).col(0);
        const LinearSolveResult r =
            method(product(a), rhs, {1e-12, 400}, precondition ? product(m) : LinearOperator());
        const Eigen::VectorXd wanted = denseSolve(a, rhs);
        CHECK(r.converged);
        CHECK((r.x - wanted).norm() <= 1e-9 * wanted.norm());
      }
}

TEST_CASE("a right-hand side of zero has the solution zero, at once") {
  const Eigen::MatrixXd a = randomSymmetric(6, 3);
  for (Method method : {Method(minres), Method(symmlq)}) {
    const LinearSolveResult r = method(product(a), Eigen::VectorXd::Zero(6), {}, {});
    CHECK(r.converged);
    CHECK(r.iterations == 0);
    CHECK(r.x == Eigen::VectorXd::Zero(6));
  }
}

TEST_CASE("MINRES solves consistent singular systems") {
  const Eigen::MatrixXd a = randomSymmetric(20, 5, 4);
  const Eigen::VectorXd rhs = a * Eigen::VectorXd::Ones(20);
  const LinearSolveResult r = minres(product(a), rhs, {1e-11, 200});
  CHECK(r.converged);
  CHECK((a * r.x - rhs).norm() <= 1e-9 * rhs.norm());
}

TEST_CASE("too few iterations are reported as not converged") {
  const Eigen::MatrixXd a = randomSymmetric(50, 8);
  const Eigen::VectorXd rhs = Eigen::VectorXd::Ones(50);
  for (Method method : {Method(minres), Method(symmlq)}) {
    const LinearSolveResult r = method(product(a), rhs, {1e-12, 3}, {});
    CHECK_FALSE(r.converged);
    CHECK(r.iterations == 3);
  }
}
