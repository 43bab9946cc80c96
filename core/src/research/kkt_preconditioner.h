#pragma once

#include <Eigen/SparseCholesky>
#include <array>

#include "research/linear_solve.h"
#include "solve/schur_system.h"

namespace abflat {

/// A symmetric positive definite approximation of the system (8): |H|; the triangles' block of the
/// Schur complement, eliminated exactly; and, of the rest, the two diagonal blocks, angle sums and
/// wheels, each a scalar Laplacian-like matrix on the mesh.
class KktPreconditioner {
 public:
  KktPreconditioner(const AngleProblem& problem, const ConstraintRows& rows);

  /// `rowScale` as in KktSystem. False if a block cannot be factored.
  bool factor(const Linearization& lin, const std::vector<std::uint8_t>& active,
              const std::vector<double>& rowScale);
  void apply(const Eigen::VectorXd& in, Eigen::VectorXd& out) const;

 private:
  struct Block {
    std::vector<std::uint32_t> rows;
    Eigen::SparseMatrix<double> matrix;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor;
  };

  const AngleProblem& problem_;
  const ConstraintRows& rows_;
  SchurSystem schur_;
  std::array<Block, 2> blocks_;              ///< sums, wheels
  std::vector<std::uint32_t> placeInBlock_;  ///< per row
  std::vector<std::uint8_t> isWheel_, active_;
  std::vector<Element> elements_;  ///< with |H|
  std::vector<double> rowScale_;
};

}  // namespace abflat
