#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "chart/disk_chart.h"
#include "refine/boundary_contact.h"

namespace abflat {

/// Keeps parts of the boundary apart that nearly touch: a barrier for each vertex and edge of the
/// boundary that are less than a reach apart (Smith and Schaefer 2015). It is a small share of the
/// chart's extent, and less where edges are short.
class BoundaryBarrier {
 public:
  /// Keeps a reference.
  BoundaryBarrier(const DiskChart& chart, double reach);

  double energy(const std::vector<double>& uv) const;

  /// Adds to the gradient, and to the lower triangle of a positive semidefinite approximation of
  /// the Hessian; two rows a vertex, u and v.
  void addDerivatives(const std::vector<double>& uv, Eigen::VectorXd& gradient,
                      SparseEntries& hessian) const;

 private:
  struct Contact;
  std::vector<Contact> contacts(const std::vector<double>& uv) const;

  const DiskChart& chart_;
  double area_, reach_;
  IdVector<BoundaryIndex, double> length_;  ///< of edges, on the surface
};

}  // namespace abflat
