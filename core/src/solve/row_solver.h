#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/parallel.h"
#include "solve/factor_memory.h"

namespace abflat {

/// Solves symmetric systems of one pattern one after another, such as those of a RowSystem.
class RowSolver {
 public:
  virtual ~RowSolver() = default;
  /// `lower` is the lower triangle. x is a guess on entry and the solution on return, which is good
  /// enough if no entry of b - A x is above `tolerance`. False if there is no solution.
  virtual bool solve(const Eigen::SparseMatrix<double>& lower, const Eigen::VectorXd& b,
                     double tolerance, Eigen::VectorXd& x) = 0;
  /// Says that what is known from earlier matrices is of no use for the next one.
  virtual void forget() {}
  /// Iterations of the last solve; 0 for a direct one.
  virtual int iterations() const { return 0; }
  /// When each row is eliminated, see CholeskySymbolic::place; null if unknown.
  virtual const std::vector<std::uint32_t>* eliminationRank() const { return nullptr; }
};

/// `lower` gives the pattern. Results do not depend on `pool`; null: one thread.
using MakeRowSolver = std::unique_ptr<RowSolver>(const Eigen::SparseMatrix<double>& lower,
                                                 ThreadPool* pool);

/// The faster of the next two, by the size of the factor.
MakeRowSolver makeRowSolver;
/// Factors every matrix.
MakeRowSolver makeDirectRowSolver;
/// Conjugate gradients with a factor in single precision of this or an earlier matrix (inexact
/// Newton); a direct solve if that does not converge or `tolerance` is 0. Half the memory.
MakeRowSolver makeInexactRowSolver;
/// Eigen's SimplicialLDLT, as the reference.
MakeRowSolver makeEigenRowSolver;

/// Like makeRowSolver if the factor fits, which is known before it is computed. If it fits only in
/// single precision, the inexact solver with MultigridRowSolver in place of direct solves;
/// otherwise MultigridRowSolver. `kind`: see Multigrid. Sets the needs in `memory`.
/// `eliminationRank`: per row, see CholeskyAnalysisOptions::place.
std::unique_ptr<RowSolver> makeRowSolverWithin(const Eigen::SparseMatrix<double>& lower,
                                               std::vector<std::uint8_t> kind, FactorMemory& memory,
                                               ThreadPool* pool = nullptr,
                                               std::vector<std::uint32_t> eliminationRank = {});

}  // namespace abflat
