#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

#include "sparse_assembly.h"

namespace abflat {

/// Places of the boundary that are nearer are held apart, in the root of the surface's area.
constexpr double kContactReach = 3e-4;

/// A vertex of the boundary and a place on one of its edges. They move apart by the sum of `share`
/// times the movement along the normal.
struct BoundaryContact {
  std::uint32_t vertex[3];  ///< the vertex, the ends of the edge
  double share[3];
  double normal[2];

  double along(const std::vector<double>& movement) const {
    double sum = 0;
    for (std::size_t i = 0; i < 6; ++i)
      sum += share[i / 2] * normal[i % 2] * movement[2 * std::size_t{vertex[i / 2]} + i % 2];
    return sum;
  }

  /// Of an energy of the distance. `hessian` gets the lower triangle; two rows a vertex, u and v.
  void addDerivatives(double slope, double curvature, Eigen::VectorXd& gradient,
                      SparseEntries& hessian) const {
    for (std::size_t i = 0; i < 6; ++i) {
      if (share[i / 2] == 0) continue;
      const double gi = share[i / 2] * normal[i % 2];
      const auto row = static_cast<int>(2 * vertex[i / 2] + i % 2);
      gradient[row] += slope * gi;
      for (std::size_t j = 0; j < 6; ++j) {
        const auto column = static_cast<int>(2 * vertex[j / 2] + j % 2);
        if (column <= row && share[j / 2] != 0)
          hessian.emplace_back(row, column, curvature * gi * share[j / 2] * normal[j % 2]);
      }
    }
  }
};

}  // namespace abflat
