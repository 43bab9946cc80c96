#include "refine/balanced_energy.h"

#include "catch.h"
#include "support/dense_algebra.h"
#include "support/plane_maps.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// The map as a matrix of the plane.
Eigen::Matrix2d jacobian(const PlaneMap& m) {
  Eigen::Matrix2d j;
  j << m[0] + m[2], -m[1] + m[3], m[1] + m[3], m[0] - m[2];
  return j;
}

}  // namespace

TEST_CASE("the energy of a triangle is that of its singular values", "[refine]") {
  for (const PlaneMap& m : someMaps()) {
    const double p = m[0] * m[0] + m[1] * m[1], q = m[2] * m[2] + m[3] * m[3];
    const Eigen::Matrix2d j = jacobian(m);
    for (const double b : {0.0, 0.1, 0.5, 1.0}) {
      const Eigen::VectorXd s = symmetricEigen(j.transpose() * j).values.cwiseSqrt();
      const double ratio = (s[0] / s[1] + s[1] / s[0]) / 2;
      const double dirichlet = (s.squaredNorm() + 1 / (s[0] * s[0]) + 1 / (s[1] * s[1])) / 4;
      CHECK(BalancedEnergy(b).at(p, q) == Approx((1 - b) * ratio + b * dirichlet).epsilon(1e-10));
    }
  }
}

TEST_CASE("at balance 0 scale makes no difference", "[refine]") {
  const BalancedEnergy angles(0);
  CHECK(angles.at(25, 0) == Approx(1));
  CHECK(angles.at(4, 1) == Approx(angles.at(100, 25)));
  CHECK(angles.shareLeft() == 1);
}

TEST_CASE("the higher the balance, the less stretch is left", "[refine]") {
  double before = 1;
  for (const double b : {0.1, 0.3, 1.0}) {
    const double share = BalancedEnergy(b).shareLeft();
    CHECK(share > 0.1);
    CHECK(share < before);
    before = share;
  }
}
