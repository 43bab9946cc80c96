#pragma once

#include <vector>

#include "chart/disk_chart.h"

namespace abflat {

/// The straight parts of an outline.
class StraightParts {
 public:
  /// The straight places are those strictly between the two ends.
  struct Run {
    BoundaryIndex from, to;
  };

  /// Keeps a reference to the chart. `straight` may be empty: no part is.
  StraightParts(const DiskChart& chart, const StraightPlaces& straight);

  std::vector<Run>::const_iterator begin() const { return runs_.begin(); }
  std::vector<Run>::const_iterator end() const { return runs_.end(); }

  /// Calls use(vertex) for every vertex strictly within a run.
  template <class Use>
  void within(const Run& run, const Use& use) const {
    for (BoundaryIndex i = chart_.after(run.from); i != run.to; i = chart_.after(i))
      use(chart_.boundaryVertex(i));
  }
  /// How far along a run a vertex lies, as a share of its length.
  double shareOf(const Run& run, ChartVertex vertex, const std::vector<double>& uv) const;

  /// Puts the vertices within each run on the line between its ends.
  void straighten(std::vector<double>& uv) const;

 private:
  const DiskChart& chart_;
  std::vector<Run> runs_;
};

}  // namespace abflat
