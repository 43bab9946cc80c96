#pragma once

#include <algorithm>
#include <cmath>

#include "refine/plane_map.h"

namespace abflat {

/// With the balance b between 0 and 1: (1 - b) (s1/s2 + s2/s1)/2 + b (s1^2 + s2^2 + s1^-2 +
/// s2^-2)/4. The first term (MIPS, Hormann and Greiner 2000) is least for similarities, the second
/// (symmetric Dirichlet) for rotations.
class BalancedEnergy {
 public:
  static constexpr double kAtRest = 1;

  explicit BalancedEnergy(double balance) : balance_(balance) {}

  double at(double p, double q) const {
    const double det = p - q, sum = p + q;
    return (1 - balance_) * sum / det + balance_ * (sum + sum / (det * det)) / 2;
  }

  SquareDerivatives derivatives(double p, double q) const {
    const double det = p - q, sum = p + q;
    const double i1 = 1 / det, i2 = i1 * i1, i3 = i2 * i1, i4 = i2 * i2;
    const double a = 1 - balance_, b = balance_, half = (1 + i2) / 2;
    return {b * (half - sum * i3) - a * 2 * q * i2, b * (half + sum * i3) + a * 2 * p * i2,
            b * (3 * sum * i4 - 2 * i3) + a * 4 * q * i3, -b * 3 * sum * i4 - a * 2 * sum * i3,
            b * (3 * sum * i4 + 2 * i3) + a * 4 * p * i3};
  }

  /// That of r^2 + r^-2, whose curvature would let a triangle grow by only a third however small it
  /// is.
  static double secantShare(double r) {
    const double i = 1 / r, i2 = i * i;
    return (1 + i + i2 + i * i2) / (1 + 3 * i2 * i2);
  }

  template <class ForMaps>
  double bestScale(const ForMaps& forMaps) const {
    if (balance_ == 0) return 1;
    double growing = 0, shrinking = 0;
    forMaps([&](double weight, const PlaneMap& m) {
      const double square = m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + m[3] * m[3];
      growing += weight * square;
      shrinking += weight * square / (determinant(m) * determinant(m));
    });
    return std::sqrt(std::sqrt(shrinking / growing));
  }

  /// Empirical.
  double shareLeft() const {
    return balance_ > 0 ? std::min(1.0, 0.24 + 0.96 / (1 + 40 * balance_)) : 1;
  }

 private:
  double balance_;
};

}  // namespace abflat
