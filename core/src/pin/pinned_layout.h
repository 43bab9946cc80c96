#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/parallel.h"
#include "base/point2.h"
#include "chart/disk_chart.h"
#include "pin/flat_region.h"
#include "solve/factor_memory.h"

namespace abflat {

/// The place of one vertex of a chart, in the chart's unit.
struct ChartPin {
  ChartVertex vertex;
  Point2 uv{0, 0};
};

struct PinnedLayout {
  std::vector<double> uv;  ///< pinned vertices are exactly at their pins
  /// Largest distance of a pin from the place where the similarity alone puts its vertex.
  double deviation = 0;
  bool isSolved = true;  ///< false: the similarity alone, apart from the pinned vertices
  FactorMemory memory;   ///< of the system for more than two pins
};

struct PinOptions {
  /// The memory that a factor may take; see makeRowSolverWithin.
  std::uint64_t allowedBytes = std::numeric_limits<std::uint64_t>::max();
  ThreadPool* pool = nullptr;  ///< results do not depend on it; null: one thread
};

/// Fits a layout with the given angles (radians, size 3F) to pins at different places.
///
/// It starts with the best similarity in the least-squares sense, which never mirrors; it meets
/// two pins exactly, and merely moves the layout to a single one. With more pins, what is left is
/// distributed by minimising the conformal energy with respect to the flat triangles, as a
/// correction. So a layout that already meets its pins stays as it is, digit for digit apart from
/// the similarity's rounding.
PinnedLayout pinLayout(const FlatRegion& region, const std::vector<double>& angles,
                       const std::vector<double>& uv, const std::vector<ChartPin>& pins,
                       const PinOptions& options = {});

}  // namespace abflat
