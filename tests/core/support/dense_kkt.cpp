#include "support/dense_kkt.h"

#include <cmath>

#include "base/constants.h"

namespace abflat::test {

Eigen::VectorXd DenseProblem::constraints(const Eigen::VectorXd& x) const {
  const auto triangles = static_cast<Eigen::Index>(problem.triangleCount());
  Eigen::VectorXd h = Eigen::VectorXd::Zero(triangles + rows.count());
  for (Eigen::Index f = 0; f < triangles; ++f) h[f] = x[3 * f] + x[3 * f + 1] + x[3 * f + 2] - kPi;
  for (const ChartVertex v : problem.vertices()) {
    const Eigen::Index r = triangles + rows.ofVertex[v];
    h[r] = -problem.angleSum[v];
    for (Eigen::Index c = 0; c < x.size(); ++c) {
      if (problem.vertexOfCorner[ChartCorner(c)] != v) continue;
      const Eigen::Index f = 3 * (c / 3);
      h[r] += x[c];
      if (!problem.isBoundary[v])
        h[r + 1] += std::log(std::sin(x[f + (c + 1) % 3])) - std::log(std::sin(x[f + (c + 2) % 3]));
    }
  }
  return h;
}

double DenseProblem::objective(const Eigen::VectorXd& x) const {
  double sum = 0;
  for (Eigen::Index c = 0; c < x.size(); ++c) {
    const double a = problem.target[ChartCorner(c)];
    sum += (x[c] - a) * (x[c] - a) / (a * a);
  }
  return sum;
}

double DenseProblem::lagrangian(const Eigen::VectorXd& x,
                                const Eigen::VectorXd& multipliers) const {
  return objective(x) + multipliers.dot(constraints(x));
}

Eigen::MatrixXd DenseProblem::jacobian(const Eigen::VectorXd& x) const {
  constexpr double kStep = 1e-6;
  Eigen::MatrixXd j(problem.triangleCount() + rows.count(), x.size());
  for (Eigen::Index c = 0; c < x.size(); ++c) {
    Eigen::VectorXd above = x, below = x;
    above[c] += kStep;
    below[c] -= kStep;
    j.col(c) = (constraints(above) - constraints(below)) / (2 * kStep);
  }
  return j;
}

Eigen::VectorXd DenseProblem::gradient(const Eigen::VectorXd& x,
                                       const Eigen::VectorXd& multipliers) const {
  constexpr double kStep = 1e-6;
  Eigen::VectorXd g(x.size());
  for (Eigen::Index c = 0; c < x.size(); ++c) {
    Eigen::VectorXd above = x, below = x;
    above[c] += kStep;
    below[c] -= kStep;
    g[c] = (lagrangian(above, multipliers) - lagrangian(below, multipliers)) / (2 * kStep);
  }
  return g;
}

}  // namespace abflat::test
