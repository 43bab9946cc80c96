#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "solve/sparse_assembly.h"

namespace abflat {

/// A symmetric matrix, stored as its lower triangle by columns, plus entries outside its pattern.
/// The pattern of the sum only grows, so that one analysis of it serves many sums.
class ExtendedMatrix {
 public:
  /// Keeps a reference to the matrix. The pattern includes `more` from the start.
  ExtendedMatrix(const Eigen::SparseMatrix<double>& own, SparseEntries more);

  /// Adds the entries to the matrix as it is now. True if the pattern is new.
  bool add(const SparseEntries& entries);

  const Eigen::SparseMatrix<double>& sum() const { return isOwn_ ? own_ : sum_; }

 private:
  void buildPattern();

  const Eigen::SparseMatrix<double>& own_;
  SparseEntries more_;  ///< places in the pattern beyond those of the matrix
  Eigen::SparseMatrix<double> sum_;
  std::vector<int> place_;  ///< per entry of the matrix: its place in the sum
  bool isOwn_ = true;       ///< the sum has no entries beyond those of the matrix
};

}  // namespace abflat
