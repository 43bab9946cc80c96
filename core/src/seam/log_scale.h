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
  /// `place`: per vertex in an elimination order, as `place()` of a surface that has these
  /// vertices; empty where none is known.
  LogScale(const SeamMesh& mesh, ThreadPool* pool, std::vector<std::uint32_t> place = {});

  /// Per vertex of the mesh. `anchors` are vertices of the cut surface that closed charts are held
  /// at; there the curvature is taken relative to its mean. Empty when the system cannot be solved.
  std::vector<double> solve(const CutSurface& surface, const std::vector<std::uint32_t>& anchors);

  /// Another right-hand side for the charts of the last solve().
  void solveAgain(std::vector<double>& b) { factor_.solve(b.data()); }

  /// Per vertex, where its row comes in the elimination: also good for any part of the surface.
  const std::vector<std::uint32_t>& place() const { return symbolic_->place; }

 private:
  void buildPattern();
  void assemble(const std::vector<std::uint8_t>& isFixed);

  const SeamMesh& mesh_;
  ThreadPool* pool_;
  std::vector<int> columnStart_, row_;
  std::vector<std::uint32_t> entryOfEdge_;  ///< per half-edge, into the values; kNone at a loop
  std::vector<double> values_;
  std::shared_ptr<const CholeskySymbolic> symbolic_;
  FloatCholesky factor_;  ///< two digits of u are plenty
};

}  // namespace abflat
