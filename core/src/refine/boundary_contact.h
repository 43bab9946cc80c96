#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "base/point2.h"
#include "base/portable_math.h"
#include "mesh/ids.h"
#include "solve/sparse_assembly.h"

namespace abflat {

/// Places of the boundary that are nearer are held apart, in the root of the surface's area. Less
/// where some touch to begin with: each step takes them to a few times their distance only.
constexpr double kContactReach = 3e-4, kContactReachOfTouching = 3e-5;

struct BarrierValue {
  double value, slope, curvature;
};

/// -(1 - x)^2 log x below 1, nothing above (Li et al. 2020). Near 0 a step of Newton's method takes
/// x to twice its distance; a barrier like 1 / x^2 would take many more steps.
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

  /// Of an energy of the quantity. `hessian` gets the lower triangle; two rows a vertex, u and v.
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

  /// w times a barrier of quantity / reach.
  void addBarrier(const BarrierValue& at, double reach, double w, Eigen::VectorXd& gradient,
                  SparseEntries& hessian) const {
    addDerivatives(w * at.slope / reach, w * at.curvature / (reach * reach), gradient, hessian);
  }
};

/// Of places of an edge, `share` of the way from its first vertex to its second, and a vertex:
/// their distance along a normal.
inline BoundaryContact distanceContact(const std::array<ChartVertex, 3>& vertex, double share,
                                       const Point2& normal) {
  const double shares[3] = {1, share - 1, -share};
  BoundaryContact out;
  out.vertex = vertex;
  for (std::size_t i = 0; i < 6; ++i) out.change[i] = shares[i / 2] * normal[i % 2];
  return out;
}

}  // namespace abflat
