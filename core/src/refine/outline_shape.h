#pragma once

#include <vector>

#include "chart/disk_chart.h"
#include "refine/boundary_contact.h"

namespace abflat {

/// What the outline has to keep.
struct OutlineRules {
  StraightPlaces straight;
  BoundaryBounds bounds;  ///< from 2 on any angle is allowed; empty: any
  /// Radians, that angles stay away from their bounds where that costs little. They begin so far
  /// away.
  double margin = 0;

  bool isEmpty() const { return straight.empty() && bounds.empty(); }
};

/// Keeps straight parts of the outline straight, and angles below their bounds.
class OutlineShape {
 public:
  /// Keeps a reference to the chart.
  OutlineShape(const DiskChart& chart, const OutlineRules& rules);

  /// Puts what lies within a straight part on the line between its ends.
  void straighten(std::vector<double>& uv) const;

  /// Infinite where an angle is not below its bound.
  double energy(const std::vector<double>& uv) const;
  /// See BoundaryBarrier. Straight parts are stiff across.
  void addDerivatives(const std::vector<double>& uv, Eigen::VectorXd& gradient,
                      SparseEntries& hessian) const;

  /// Where the Hessian may have entries, whatever the layout.
  SparseEntries entries() const;

  struct Bound {
    BoundaryIndex place;
    double most, weight;
  };
  const std::vector<Bound>& bounds() const { return bounds_; }
  double margin() const { return margin_; }

  /// What an angle is below its bound, and how that changes.
  struct Slack {
    double value;
    BoundaryContact contact;
  };
  Slack slackOf(const Bound& bound, const std::vector<double>& uv) const;

 private:
  /// Straight places come between.
  struct Run {
    BoundaryIndex from, to;
  };
  void findRuns(const StraightPlaces& straight);
  void findBounds(const OutlineRules& rules);
  /// A boundary vertex, the one before and the one after it.
  std::array<ChartVertex, 3> cornerAt(BoundaryIndex i) const {
    return {chart_.boundaryVertex(i), chart_.boundaryVertex(chart_.before(i)),
            chart_.boundaryVertex(chart_.after(i))};
  }
  /// use(vertex) for what lies within a run.
  template <class Use>
  void within(const Run& run, const Use& use) const;
  /// How far along a run a vertex lies, as a share of it.
  double shareOf(const Run& run, ChartVertex vertex, const std::vector<double>& uv) const;

  const DiskChart& chart_;
  double margin_;
  std::vector<Run> runs_;
  std::vector<Bound> bounds_;
};

}  // namespace abflat
