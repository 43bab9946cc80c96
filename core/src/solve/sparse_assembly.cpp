#include "solve/sparse_assembly.h"

namespace abflat {

Eigen::SparseMatrix<double> assembled(Eigen::Index n, const SparseEntries& entries) {
  if (n <= 0) return {};
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace abflat
