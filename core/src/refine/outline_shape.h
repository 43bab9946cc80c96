#pragma once

#include <vector>

#include "chart/disk_chart.h"
#include "refine/boundary_contact.h"

namespace abflat {

/// What the outline has to conform to.
struct OutlineRules {
  StraightPlaces straight;
  BoundaryBounds bounds;  ///< 2 or more: any angle is allowed; empty: no bounds
  /// Radians: distance that angles keep from their bounds where that costs little. They start out
  /// this far away.
  double margin = 0;

  bool isEmpty() const { return straight.empty() && bounds.empty(); }
};

/// Keeps straight parts of the outline straight, and angles below their bounds.
class OutlineShape {
 public:
  /// Keeps a reference to the chart.
  OutlineShape(const DiskChart& chart, const OutlineRules& rules);

  /// Puts the vertices within a straight part on the line between its ends.
  void straighten(std::vector<double>& uv) const;

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
  /// The straight places are those strictly between the two ends.
  struct Run {
    BoundaryIndex from, to;
  };
  void findRuns(const StraightPlaces& straight);
  void findBounds(const OutlineRules& rules);
  /// A boundary vertex, followed by the one before it and the one after it.
  std::array<ChartVertex, 3> cornerAt(BoundaryIndex i) const {
    return {chart_.boundaryVertex(i), chart_.boundaryVertex(chart_.before(i)),
            chart_.boundaryVertex(chart_.after(i))};
  }
  /// Calls use(vertex) for every vertex strictly within a run.
  template <class Use>
  void within(const Run& run, const Use& use) const;
  /// How far along a run a vertex lies, as a share of its length.
  double shareOf(const Run& run, ChartVertex vertex, const std::vector<double>& uv) const;

  const DiskChart& chart_;
  double margin_;
  std::vector<Run> runs_;
  std::vector<Bound> bounds_;
};

}  // namespace abflat
