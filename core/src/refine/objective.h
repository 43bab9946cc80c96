#pragma once

#include <optional>
#include <vector>

#include "refine/boundary_barrier.h"
#include "refine/energy.h"
#include "refine/level_springs.h"
#include "refine/outline_shape.h"
#include "refine/refine.h"
#include "refine/rest_triangles.h"

namespace abflat {

/// What the steps lower: the energy of the layout and of all that holds its outline.
struct Objective {
  /// Keeps references to the chart and to edges in the options. `uv`: see restTriangles.
  Objective(const DiskChart& chart, const std::vector<double>& uv, const RefineOptions& options);

  /// The energy of the layout alone.
  double ofLayout(const std::vector<double>& uv) const;
  double at(const std::vector<double>& uv) const;

  /// Adds those of what holds the outline. `hessian`: see BoundaryBarrier.
  void addOutlineDerivatives(const std::vector<double>& uv, Eigen::VectorXd& gradient,
                             SparseEntries& hessian) const;

  const DiskChart& chart;
  Energy energy;
  RestTriangles rest;
  OutlineShape shape;
  LevelSprings springs;
  std::optional<BoundaryBarrier> barrier;  ///< once the boundary would cross itself
  ThreadPool* pool;
};

}  // namespace abflat
