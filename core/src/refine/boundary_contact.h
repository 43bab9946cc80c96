#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "base/point2.h"
#include "base/portable_math.h"
#include "mesh/ids.h"
#include "solve/sparse_assembly.h"

namespace abflat {

/// Places of the boundary nearer than this are held apart, in units of the square root of the
/// surface's area. The smaller value applies if some touch from the start, because each step takes
/// them to only a few times their distance.
constexpr double kContactReach = 3e-4, kContactReachOfTouching = 3e-5;

struct BarrierValue {
  double value, slope, curvature;
};

/// -(1 - x)^2 log x below 1, zero above (Li et al. 2020). Near 0 a Newton step doubles x; with a
/// barrier like 1 / x^2 many more steps would be needed.
inline BarrierValue barrierAt(double x) {
  if (x >= 1) return {0, 0, 0};
  const double rest = 1 - x, log = portable::log(x);
  return {-rest * rest * log, 2 * rest * log - rest * rest / x,
          rest * (4 / x + rest / (x * x)) - 2 * log};
}

/// How a quantity changes when three vertices of the boundary move, u and v of each.
struct BoundaryContact {
  std::array<ChartVertex, 3> vertex;
  double change[6];

  double along(const std::vector<double>& movement) const {
    double sum = 0;
    for (std::size_t i = 0; i < 6; ++i)
      sum += change[i] * movement[2 * std::size_t{vertex[i / 2]} + i % 2];
    return sum;
  }

  /// Adds the derivatives of an energy of the quantity. `hessian` gets the lower triangle; two rows
  /// per vertex, u and v.
  void addDerivatives(double slope, double curvature, Eigen::VectorXd& gradient,
                      SparseEntries& hessian) const {
    for (std::size_t i = 0; i < 6; ++i) {
      if (change[i] == 0) continue;
      const auto row = static_cast<int>(2 * vertex[i / 2] + i % 2);
      gradient[row] += slope * change[i];
      for (std::size_t j = 0; j < 6; ++j) {
        const auto column = static_cast<int>(2 * vertex[j / 2] + j % 2);
        if (column <= row && change[j] != 0)
          hessian.emplace_back(row, column, curvature * change[i] * change[j]);
      }
    }
  }

  /// Adds those of w times a barrier of quantity / reach.
  void addBarrier(const BarrierValue& at, double reach, double w, Eigen::VectorXd& gradient,
                  SparseEntries& hessian) const {
    addDerivatives(w * at.slope / reach, w * at.curvature / (reach * reach), gradient, hessian);
  }
};

/// The distance along a normal between a vertex and the place on an edge that is `share` of the way
/// from its first vertex to its second.
inline BoundaryContact distanceContact(const std::array<ChartVertex, 3>& vertex, double share,
                                       const Point2& normal) {
  const double shares[3] = {1, share - 1, -share};
  BoundaryContact out;
  out.vertex = vertex;
  for (std::size_t i = 0; i < 6; ++i) out.change[i] = shares[i / 2] * normal[i % 2];
  return out;
}

}  // namespace abflat
