#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

#include "sparse_assembly.h"

namespace abflat {

/// Places of the boundary that are nearer are held apart, in the root of the surface's area.
constexpr double kContactReach = 3e-4;

/// How a quantity changes when three vertices of the boundary move, u and v of each.
struct BoundaryContact {
  std::uint32_t vertex[3];
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

  /// w (reach / quantity - 1)^2.
  void addBarrier(double quantity, double reach, double w, Eigen::VectorXd& gradient,
                  SparseEntries& hessian) const {
    const double ratio = reach / quantity, inverse = 1 / quantity;
    addDerivatives(-2 * w * (ratio - 1) * ratio * inverse,
                   2 * w * ratio * (3 * ratio - 2) * inverse * inverse, gradient, hessian);
  }
};

/// Of places of an edge, `share` of the way from its first vertex to its second, and a vertex:
/// their distance along a normal.
inline BoundaryContact distanceContact(const std::uint32_t (&vertex)[3], double share, double nx,
                                       double ny) {
  const double shares[3] = {1, share - 1, -share};
  BoundaryContact out;
  for (std::size_t k = 0; k < 3; ++k) {
    out.vertex[k] = vertex[k];
    out.change[2 * k] = shares[k] * nx;
    out.change[2 * k + 1] = shares[k] * ny;
  }
  return out;
}

}  // namespace abflat
