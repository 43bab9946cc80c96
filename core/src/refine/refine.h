#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "base/parallel.h"
#include "chart/disk_chart.h"
#include "refine/outline_shape.h"
#include "solve/factor_memory.h"

namespace abflat {

struct RefineOptions {
  double balance = 0;  ///< see elementEnergy; nothing is to be done for 0
  /// Which vertices stay where they are; empty: none.
  IdVector<ChartVertex, std::uint8_t> isFixed;
  OutlineRules outline;  ///< the layout has to keep to it from the start
  int maxSteps = 100;
  int maxSolves = std::numeric_limits<int>::max();  ///< of linear systems, in all steps together
  /// Of the energy above 1, and 1/40 of that of the whole: it does not matter that further steps
  /// would gain less.
  double tolerance = 4e-3;
  /// Of the energy: nor does this, once the boundary is held and a step takes several systems.
  double leastHeld = 0;
  /// Where another is known than that of the chart; empty: none.
  IdVector<ChartVertex, std::uint32_t> eliminationRank;
  std::uint64_t allowedBytes = std::numeric_limits<std::uint64_t>::max();
  ThreadPool* pool = nullptr;  ///< results do not depend on it; null: one thread
  /// Hears of each step; false: no further one.
  std::function<bool()> onStep;
};

struct Refinement {
  std::vector<double> uv;
  double energyBefore = 0, energy = 0;
  int steps = 0;
  bool isConverged = false;  ///< false: ended by the limit of steps, by rounding or by the caller
  bool isHeldApart = false;  ///< the boundary would have crossed itself
  FactorMemory memory;
};

/// From a layout without flipped triangles to another of less energy, by projected Newton (Teran et
/// al. 2005; eigenvalues in closed form after Smith, de Goes and Kim 2019) with steps that flip no
/// triangle (Smith and Schaefer 2015). The boundary is free. Energies are those at the scale where
/// the layout that is given has the least; it is scaled to that, unless something is fixed. One
/// that does not cross itself is kept apart where it would; one that does may go on to, until it no
/// longer does.
Refinement refine(const DiskChart& chart, std::vector<double> uv, const RefineOptions& options);

/// Of a layout, at the scale where it is least.
double energyOf(const DiskChart& chart, const std::vector<double>& uv, double balance);

}  // namespace abflat
