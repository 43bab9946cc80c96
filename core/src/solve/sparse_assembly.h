#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace abflat {

using SparseEntries = std::vector<Eigen::Triplet<double>>;

/// Square matrix of size n; entries at the same place add up.
inline Eigen::SparseMatrix<double> assembled(Eigen::Index n, const SparseEntries& entries) {
  if (n <= 0) return {};
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace abflat
