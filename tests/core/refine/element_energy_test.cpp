#include "refine/element_energy.h"

#include <random>

#include "catch.h"
#include "support/dense_algebra.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Random orientation-preserving maps, from nearly conformal to nearly singular.
std::vector<PlaneMap> someMaps() {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<PlaneMap> out{{1, 0, 0, 0}, {0, -3, 0, 0}, {0.6, 0.8, 0, 0}};
  while (out.size() < 200) {
    PlaneMap m;
    for (double& x : m) x = normal(random);
    const double det = m[0] * m[0] + m[1] * m[1] - m[2] * m[2] - m[3] * m[3];
    if (det > 0.05) out.push_back(m);
  }
  return out;
}

/// The map as a matrix of the plane.
Eigen::Matrix2d jacobian(const PlaneMap& m) {
  Eigen::Matrix2d j;
  j << m[0] + m[2], -m[1] + m[3], m[1] + m[3], m[0] - m[2];
  return j;
}

PlaneMap moved(PlaneMap m, std::size_t i, double by) {
  m[i] += by;
  return m;
}

Eigen::Matrix4d symmetric(const std::array<double, 10>& lower) {
  Eigen::Matrix4d out;
  for (Eigen::Index i = 0, k = 0; i < 4; ++i)
    for (Eigen::Index j = 0; j <= i; ++j, ++k)
      out(i, j) = out(j, i) = lower[static_cast<std::size_t>(k)];
  return out;
}

constexpr double kBalances[] = {0, 0.1, 0.5, 1};

}  // namespace

TEST_CASE("the energy of a triangle is that of its singular values", "[refine]") {
  for (const PlaneMap& m : someMaps())
    for (const double b : kBalances) {
      const Eigen::Matrix2d j = jacobian(m);
      const Eigen::VectorXd s = symmetricEigen(j.transpose() * j).values.cwiseSqrt();
      const double ratio = (s[0] / s[1] + s[1] / s[0]) / 2;
      const double dirichlet = (s.squaredNorm() + 1 / (s[0] * s[0]) + 1 / (s[1] * s[1])) / 4;
      CHECK(elementEnergy(m, b) == Approx((1 - b) * ratio + b * dirichlet).epsilon(1e-10));
      CHECK(elementEnergy(m, b) >= 1 - 1e-14);
    }
  for (const double b : kBalances) CHECK(elementEnergy({0.6, -0.8, 0, 0}, b) == Approx(1));
  CHECK(elementEnergy({3, 4, 0, 0}, 0) == Approx(1));
}

TEST_CASE("derivatives of the energy agree with differences, without negative curvature",
          "[refine]") {
  constexpr double kStep = 1e-5;
  for (const PlaneMap& m : someMaps())
    for (const double b : kBalances) {
      const ElementDerivatives d = elementDerivatives(m, b);
      Eigen::Matrix4d differences;
      for (std::size_t i = 0; i < 4; ++i) {
        const double slope =
            (elementEnergy(moved(m, i, kStep), b) - elementEnergy(moved(m, i, -kStep), b)) /
            (2 * kStep);
        CHECK(d.gradient[i] == Approx(slope).epsilon(1e-4).margin(1e-6));
        const PlaneMap up = elementDerivatives(moved(m, i, kStep), b).gradient;
        const PlaneMap down = elementDerivatives(moved(m, i, -kStep), b).gradient;
        for (std::size_t j = 0; j < 4; ++j)
          differences(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) =
              (up[j] - down[j]) / (2 * kStep);
      }
      const SymmetricEigen eigen = symmetricEigen((differences + differences.transpose()) / 2);
      const Eigen::Matrix4d wanted =
          eigen.vectors * eigen.values.cwiseMax(0).asDiagonal() * eigen.vectors.transpose();
      const double size = eigen.values.cwiseAbs().maxCoeff();
      CHECK((symmetric(d.hessian) - wanted).cwiseAbs().maxCoeff() <= 1e-5 * size + 1e-6);
    }
}

TEST_CASE("from far away a triangle of any scale goes to scale 1 in one step", "[refine]") {
  for (const double r : {1e-3, 0.1, 0.7, 1.0, 1.5, 20.0}) {
    const double x = 0.6 * r, y = 0.8 * r;
    const ElementDerivatives d = elementDerivatives({x, y, 0, 0}, 1, ElementCurvature::Far);
    const Eigen::Matrix4d h = symmetric(d.hessian);
    const Eigen::Vector4d out{0.6, 0.8, 0, 0},
        gradient = Eigen::Map<const Eigen::Vector4d>(d.gradient.data());
    CHECK(r - out.dot(gradient) / out.dot(h * out) == Approx(1));
  }
  for (const PlaneMap& m : someMaps())
    for (const double b : kBalances) {
      const ElementDerivatives far = elementDerivatives(m, b, ElementCurvature::Far);
      CHECK(far.gradient == elementDerivatives(m, b).gradient);
      const Eigen::VectorXd values = symmetricEigen(symmetric(far.hessian)).values;
      CHECK(values.minCoeff() >= -1e-9 * values.maxCoeff());
    }
}
