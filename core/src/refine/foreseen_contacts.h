#pragma once

#include <vector>

#include "chart/disk_chart.h"
#include "refine/boundary_contact.h"

namespace abflat {

/// Places where the boundary would cross itself along a step. Springs keep them apart in the model
/// of the energy that the step minimises, so that the step is not cut short there.
class ForeseenContacts {
 public:
  /// Keeps a reference.
  explicit ForeseenContacts(const DiskChart& chart);

  /// Of the springs that the last step needed, keeps those that the next one from `uv` may need.
  void begin(const std::vector<double>& uv);

  /// Looks along a step that was found with the springs so far: adds some where it crosses, takes
  /// away those that pull. False where the step is as good as it gets: crosses nowhere, or only
  /// where springs do not help.
  bool update(const std::vector<double>& uv, const std::vector<double>& step, double length);

  void clear() { springs_.clear(); }

  /// Of the springs' energy where `begin` was told.
  void addDerivatives(Eigen::VectorXd& gradient, SparseEntries& hessian) const;

 private:
  struct Spring {
    std::uint32_t point, edge;  ///< along the boundary
    BoundaryContact contact;
    double gap;     ///< now
    double target;  ///< after the step, at least
    double stiffness;
  };

  Spring springAt(const std::vector<double>& now, const std::vector<double>& then,
                  std::uint32_t point, std::uint32_t edge) const;
  bool releasePulling(const std::vector<double>& step);
  /// Where the step would go through it.
  bool add(const Spring& spring, const std::vector<double>& step);

  const DiskChart& chart_;
  double area_, distance_;
  std::vector<Spring> springs_;  ///< by points, then by edges
};

}  // namespace abflat
