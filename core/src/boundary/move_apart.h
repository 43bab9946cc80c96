#pragma once

#include <functional>
#include <string>
#include <vector>

#include "boundary/chart_flattener.h"

namespace abflat {

/// A layout whose only defect is that its boundary crosses or touches itself.
struct TouchingLayout {
  const DiskChart& chart;
  const std::vector<double>& uv;
  const StraightPlaces& straight;
  const std::vector<double>& turned;  ///< see turnedAlong()
};

struct MovedBack {
  bool isApart = false;
  std::vector<double> uv;
  std::size_t moved = 0;  ///< number of boundary vertices
  double farthest = 0;
};

struct MoveLengths {
  double first = 0;
  double deepest = 0;  ///< 0: within the triangles at the boundary
};

/// Draws the arcs that cross back into the chart: by `lengths.first`, then twice as far each time,
/// until `crossings`, which were `left` at first, finds none. At first each triangle keeps its
/// orientation; where that leaves too little room, what lies around is carried along, and hardly
/// any triangle turns over.
MovedBack moveBack(const TouchingLayout& layout, const MoveLengths& lengths, Crossings left,
                   const std::function<Crossings(const std::vector<double>&)>& crossings);

/// What was moved back, in one sentence.
std::string movedBackNote(const MovedBack& back, const DiskChart& chart);

/// Takes a layout whose only defect is that its boundary crosses or touches itself, and draws the
/// arcs that cross back into the chart, by little compared with the chart. That needs no solution.
/// A straight run moves as a whole and stays straight. Slits in nearly flat parts close again when
/// they are flattened, and tighter bounds on some vertices only move the place where they do. The
/// result is not valid if a small move does not help, or would exceed a bound.
/// `deepest`: how far what lies around may be carried along, as a share of the chart's extent.
Attempt movedApart(ChartFlattener& flattener, const Attempt& crossing, double deepest = 0);

}  // namespace abflat
