#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "chart/disk_chart.h"
#include "solve/row_solver.h"

namespace abflat {

/// Triangles of a region in the plane, which may have holes.
struct FlatRegion {
  const IdVector<ChartCorner, ChartVertex>& vertexOfCorner;
  /// Half-edges of all boundary loops, in any order, with the region on their left.
  const IdVector<BoundaryIndex, ChartCorner>& boundary;
};

/// Twice the conformal energy of Lévy et al., "Least squares conformal maps", 2002, as a quadratic
/// form x^T E x: Dirichlet energy minus uv area, twice each. x has size 2V: all u, then all v.
/// Positive semidefinite; 0 where every triangle has the given angles (radians, size 3F, in
/// (0, pi)).
Eigen::SparseMatrix<double> conformalEnergy(const FlatRegion& region, std::size_t vertices,
                                            const std::vector<double>& angles);

/// Minimises the energy with two or more pinned vertices held where `uv` has them, and replaces the
/// uv of all others. False, leaving uv unchanged, if the system is singular to floating-point
/// precision or if, with no factor because of `memory`, the iterations do not converge. Sets the
/// memory that a factor needs. Results do not depend on `pool`; null: one thread.
bool relaxConformally(const Eigen::SparseMatrix<double>& energy,
                      const std::vector<ChartVertex>& pinned, std::vector<double>& uv,
                      FactorMemory& memory, ThreadPool* pool = nullptr);

}  // namespace abflat
