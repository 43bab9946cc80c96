#pragma once

#include <vector>

#include "chart/disk_chart.h"
#include "refine/boundary_contact.h"
#include "refine/outline_rules.h"
#include "refine/straight_parts.h"

namespace abflat {

/// Keeps straight parts of the outline straight, and angles below their bounds.
class OutlineShape {
 public:
  /// Keeps a reference to the chart.
  OutlineShape(const DiskChart& chart, const OutlineRules& rules);

  /// Puts the vertices within a straight part on the line between its ends.
  void straighten(std::vector<double>& uv) const { straight_.straighten(uv); }

  /// Infinite if an angle is not below its bound.
  double energy(const std::vector<double>& uv) const;
  /// See BoundaryBarrier. Straight parts are stiff in the perpendicular direction.
  void addDerivatives(const std::vector<double>& uv, Eigen::VectorXd& gradient,
                      SparseEntries& hessian) const;

  /// Where the Hessian may have entries, for any layout.
  SparseEntries entries() const;

  struct Bound {
    BoundaryIndex place;
    double most, weight;
  };
  const std::vector<Bound>& bounds() const { return bounds_; }
  double margin() const { return margin_; }

  /// How far an angle is below its bound, and how that changes.
  struct Slack {
    double value;
    BoundaryContact contact;
  };
  Slack slackOf(const Bound& bound, const std::vector<double>& uv) const;

 private:
  void findBounds(const OutlineRules& rules);
  /// A boundary vertex, followed by the one before it and the one after it.
  std::array<ChartVertex, 3> cornerAt(BoundaryIndex i) const {
    return {chart_.boundaryVertex(i), chart_.boundaryVertex(chart_.before(i)),
            chart_.boundaryVertex(chart_.after(i))};
  }

  const DiskChart& chart_;
  StraightParts straight_;
  double margin_;
  std::vector<Bound> bounds_;
};

}  // namespace abflat
