#pragma once

#include <vector>

#include "refine/level_edges.h"
#include "solve/sparse_assembly.h"

namespace abflat {

/// The energy of edges that should lie along an axis: the mean square of their slope, by length,
/// times the stiffness.
class LevelSprings {
 public:
  explicit LevelSprings(const LevelEdges& level);

  bool isEmpty() const { return edges_.empty(); }
  double energy(const std::vector<double>& uv) const;
  /// `hessian` gets the lower triangle; two rows per vertex, u and v. Its pattern is that of the
  /// chart's edges.
  void addDerivatives(const std::vector<double>& uv, Eigen::VectorXd& gradient,
                      SparseEntries& hessian) const;

 private:
  const std::vector<LevelEdge>& edges_;
  double strength_ = 0;  ///< of an edge as long as 1
};

}  // namespace abflat
