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

/// Draws the arcs that cross back into the chart: by `first`, then twice as far each time, until
/// `crossings`, which were `left` at first, finds none. Each triangle keeps its orientation, so
/// there may be too little room.
MovedBack moveBack(const TouchingLayout& layout, double first, Crossings left,
                   const std::function<Crossings(const std::vector<double>&)>& crossings);

/// What was moved back, in one sentence.
std::string movedBackNote(const MovedBack& back, const DiskChart& chart);

/// Takes a layout whose only defect is that its boundary crosses or touches itself, and draws the
/// arcs that cross back into the chart, by little compared with the triangles there. That needs no
/// solution. A straight run moves as a whole and stays straight. Slits in nearly flat parts close
/// again when they are flattened, and tighter bounds on some vertices only move the place where
/// they do. The result is not valid if a small move does not help, or would exceed a bound.
Attempt movedApart(ChartFlattener& flattener, const Attempt& crossing);

}  // namespace abflat
