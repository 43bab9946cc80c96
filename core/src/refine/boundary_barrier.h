#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "chart/disk_chart.h"
#include "refine/boundary_contact.h"

namespace abflat {

/// Keeps parts of the boundary that nearly touch apart: a barrier for each vertex and edge of the
/// boundary that are closer than a reach (Smith and Schaefer 2015). The reach is a small share of
/// the chart's extent, and smaller where edges are short.
class BoundaryBarrier {
 public:
  /// Keeps a reference to the chart.
  BoundaryBarrier(const DiskChart& chart, double reach);

  double energy(const std::vector<double>& uv) const;

  /// Adds to the gradient, and to the lower triangle of a positive semidefinite approximation of
  /// the Hessian; two rows per vertex, u and v.
  void addDerivatives(const std::vector<double>& uv, Eigen::VectorXd& gradient,
                      SparseEntries& hessian) const;

 private:
  struct Contact;
  std::vector<Contact> contacts(const std::vector<double>& uv) const;

  const DiskChart& chart_;
  double area_, reach_;
  IdVector<BoundaryIndex, double> length_;  ///< of edges, in 3D
};

}  // namespace abflat
