#pragma once

#include <vector>

#include "base/parallel.h"
#include "base/point2.h"
#include "chart/disk_chart.h"
#include "solve/factor_memory.h"

namespace abflat {

/// A place for one vertex of a chart, in the chart's unit.
struct ChartPin {
  ChartVertex vertex;
  Point2 uv{0, 0};
};

struct PinnedLayout {
  std::vector<double> uv;  ///< pinned vertices are exactly where they are pinned
  /// Largest distance of a pin from where a similarity of the layout alone has its vertex.
  double deviation = 0;
  bool isSolved = true;  ///< false: the similarity alone, but for the pinned vertices
  FactorMemory memory;   ///< of the system for more than two pins
};

struct PinOptions {
  /// What a factor may take; see makeRowSolverWithin.
  std::uint64_t allowedBytes = std::numeric_limits<std::uint64_t>::max();
  ThreadPool* pool = nullptr;  ///< results do not depend on it; null: one thread
};

/// A layout of the given angles (radians, size 3F) made to meet two or more pins at different
/// places.
///
/// The similarity that fits best in the sense of least squares, which never mirrors, comes first:
/// it meets two pins. What is left at more of them is spread by the least conformal energy with
/// respect to the flat triangles, as a correction: so a layout that meets its pins already stays as
/// it is, digit by digit but for the similarity's rounding.
PinnedLayout pinLayout(const DiskChart& chart, const std::vector<double>& angles,
                       const std::vector<double>& uv, const std::vector<ChartPin>& pins,
                       const PinOptions& options = {});

}  // namespace abflat
