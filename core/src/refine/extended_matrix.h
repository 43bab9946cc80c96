#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "solve/sparse_assembly.h"

namespace abflat {

/// A symmetric matrix, lower triangle by columns, and entries that its pattern does not have. The
/// pattern of the sum only grows, so that one analysis of it serves many sums.
class ExtendedMatrix {
 public:
  /// Keeps a reference to the matrix. The pattern has `more` from the start.
  ExtendedMatrix(const Eigen::SparseMatrix<double>& own, SparseEntries more);

  /// Of the matrix as it is now and what is added. True where the pattern is new.
  bool add(const SparseEntries& entries);

  const Eigen::SparseMatrix<double>& sum() const { return isOwn_ ? own_ : sum_; }

 private:
  void buildPattern();

  const Eigen::SparseMatrix<double>& own_;
  SparseEntries more_;  ///< places of the pattern beside those of the matrix
  Eigen::SparseMatrix<double> sum_;
  std::vector<int> place_;  ///< in the sum, of each entry of the matrix
  bool isOwn_ = true;       ///< the sum has no more entries than the matrix
};

}  // namespace abflat
