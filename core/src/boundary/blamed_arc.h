#pragma once

#include <cstddef>
#include <vector>

#include "chart/disk_chart.h"
#include "solve/angle_solution.h"

namespace abflat {

/// Interior angles at the boundary vertices, radians.
IdVector<BoundaryIndex, double> boundaryAngles(const DiskChart& chart, const AngleSolution& s);

/// The same, of the layout itself.
IdVector<BoundaryIndex, double> boundaryAngles(const DiskChart& chart,
                                               const std::vector<double>& uv);

/// How far the boundary has turned: prefix sums of pi - angle.
std::vector<double> turnedAlong(const IdVector<BoundaryIndex, double>& boundaryAngles);

/// A run of boundary vertices first, first + 1, ... (cyclic).
struct Arc {
  std::size_t first, count;

  /// The boundary index `k` places into the arc, on a boundary of n vertices.
  BoundaryIndex at(std::size_t k, std::size_t n) const { return BoundaryIndex((first + k) % n); }
};

/// Of the two arcs between crossing edges i < j, the one that turns more clockwise: it closes a
/// loop the wrong way round, or folds two parts of the boundary over each other.
Arc blamedArc(std::size_t i, std::size_t j, const std::vector<double>& turned);

}  // namespace abflat
