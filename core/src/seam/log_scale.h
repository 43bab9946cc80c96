#pragma once

#include <memory>
#include <vector>

#include "base/parallel.h"
#include "cut/cut_surface.h"
#include "solve/cholesky/cholesky.h"

namespace abflat {

/// The scale that a conformal flattening needs at each vertex, from one linear system:
/// sum_j w_ij (u_i - u_j) = (sum of angles at i) - 2 pi inside, u = 0 on seams and boundaries
/// (Springborn et al. 2008, linearised; this boundary distorts areas least). Lengths grow by e^u.
class LogScale {
 public:
  /// `ranks`: those of a mesh that contains these vertices; empty if unknown.
  LogScale(const SeamMesh& mesh, ThreadPool* pool, EliminationRanks ranks = {});

  /// `anchors` are vertices of the cut surface at which closed charts are held; in these charts
  /// curvature is taken relative to its mean. Empty if the system cannot be solved.
  LogScales solve(const CutSurface& surface, const std::vector<OpenVertex>& anchors);

  /// Solves with another right-hand side, for the charts of the last solve().
  void solveAgain(IdVector<SurfaceVertex, double>& b) { factor_.solve(b.raw().data()); }

  EliminationRanks eliminationRanks() const { return EliminationRanks(symbolic_->eliminationRank); }

 private:
  void buildPattern();
  void assemble(const IdVector<SurfaceVertex, std::uint8_t>& isFixed);

  const SeamMesh& mesh_;
  ThreadPool* pool_;
  std::vector<int> columnStart_, row_;
  /// Index of a half-edge's entry in values_; kNone if it has none.
  IdVector<SurfaceCorner, std::uint32_t> entryOfEdge_;
  std::vector<double> values_;
  std::shared_ptr<const CholeskySymbolic> symbolic_;
  FloatCholesky factor_;  ///< two digits of u are plenty
};

}  // namespace abflat
