#pragma once

#include <vector>

#include "chart/disk_chart.h"
#include "solve/sparse_assembly.h"

namespace abflat {

/// An edge of the outline that should lie along an axis.
struct LevelEdge {
  ChartVertex from, to;
  std::uint8_t across = 0;  ///< the coordinate that should be the same at both: 0 for u, 1 for v
  double length = 0;        ///< on the surface
};

/// Edges that should lie along an axis, held by springs.
struct LevelEdges {
  std::vector<LevelEdge> edges;
  double stiffness = 0;  ///< energy per square of the slope, if all edges had that slope
};

/// Their energy: the mean square of their slope, by length, times the stiffness.
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
