#include "refine/element_energy.h"

#include "catch.h"
#include "support/dense_algebra.h"
#include "support/plane_maps.h"

using namespace abflat;
using namespace abflat::test;

namespace {

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

std::vector<Energy> someEnergies() { return {Energy(0), Energy(0.1), Energy(0.5), Energy(1)}; }

}  // namespace

TEST_CASE("the energy is least for rigid maps, whatever the direction", "[refine]") {
  for (const Energy& energy : someEnergies()) {
    CHECK(elementEnergy({0.6, -0.8, 0, 0}, energy) == Approx(Energy::kAtRest));
    for (const PlaneMap& m : someMaps()) {
      const double value = elementEnergy(m, energy);
      CHECK(value >= Energy::kAtRest - 1e-14);
      // Turned by 90 degrees before and after.
      CHECK(elementEnergy({-m[1], m[0], m[3], -m[2]}, energy) == Approx(value));
      CHECK(elementEnergy({-m[1], m[0], -m[3], m[2]}, energy) == Approx(value));
    }
  }
}

TEST_CASE("derivatives of the energy agree with differences, without negative curvature",
          "[refine]") {
  constexpr double kStep = 1e-5;
  for (const PlaneMap& m : someMaps())
    for (const Energy& energy : someEnergies()) {
      const ElementDerivatives d = elementDerivatives(m, energy);
      Eigen::Matrix4d differences;
      for (std::size_t i = 0; i < 4; ++i) {
        const double slope = (elementEnergy(moved(m, i, kStep), energy) -
                              elementEnergy(moved(m, i, -kStep), energy)) /
                             (2 * kStep);
        CHECK(d.gradient[i] == Approx(slope).epsilon(1e-4).margin(1e-6));
        const PlaneMap up = elementDerivatives(moved(m, i, kStep), energy).gradient;
        const PlaneMap down = elementDerivatives(moved(m, i, -kStep), energy).gradient;
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
    const ElementDerivatives d = elementDerivatives({x, y, 0, 0}, Energy(1), ElementCurvature::Far);
    const Eigen::Matrix4d h = symmetric(d.hessian);
    const Eigen::Vector4d out{0.6, 0.8, 0, 0},
        gradient = Eigen::Map<const Eigen::Vector4d>(d.gradient.data());
    CHECK(r - out.dot(gradient) / out.dot(h * out) == Approx(1));
  }
  for (const PlaneMap& m : someMaps())
    for (const Energy& energy : someEnergies()) {
      const ElementDerivatives far = elementDerivatives(m, energy, ElementCurvature::Far);
      CHECK(far.gradient == elementDerivatives(m, energy).gradient);
      const Eigen::VectorXd values = symmetricEigen(symmetric(far.hessian)).values;
      CHECK(values.minCoeff() >= -1e-9 * values.maxCoeff());
    }
}
