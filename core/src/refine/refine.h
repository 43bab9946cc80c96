#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/listener.h"
#include "base/parallel.h"
#include "chart/disk_chart.h"
#include "refine/energy.h"
#include "refine/level_edges.h"
#include "refine/outline_rules.h"
#include "solve/factor_memory.h"

namespace abflat {

struct RefineOptions {
  Energy energy = Energy(0);
  /// Which vertices stay where they are; empty: none.
  IdVector<ChartVertex, std::uint8_t> isFixed;
  OutlineRules outline;  ///< the layout has to conform to it from the start
  LevelEdges level;      ///< pulled along an axis; their energy counts while steps are taken
  int maxSteps = 100;
  int maxSolves = std::numeric_limits<int>::max();  ///< linear systems, over all steps
  /// The iteration ends once further steps would gain less than this share of the energy above 1
  /// and of 1/40 of the whole energy.
  double tolerance = 4e-3;
  /// In units of energy: the gain that may be forgone in addition, once the boundary is held and a
  /// step solves several systems.
  double leastHeld = 0;
  /// An elimination rank to use in place of the chart's; empty: none.
  IdVector<ChartVertex, std::uint32_t> eliminationRank;
  std::uint64_t allowedBytes = std::numeric_limits<std::uint64_t>::max();
  ThreadPool* pool = nullptr;  ///< results do not depend on it; null: one thread
  Listener listener;           ///< told of each step
};

struct Refinement {
  std::vector<double> uv;
  double energyBefore = 0, energy = 0;
  int steps = 0;
  bool isConverged = false;  ///< false: stopped by a limit, by rounding or by the caller
  bool isHeldApart = false;  ///< the boundary would otherwise have crossed itself
  FactorMemory memory;
};

/// Takes a layout without flipped triangles to one of less energy, by projected Newton (Teran et
/// al. 2005; eigenvalues in closed form after Smith, de Goes and Kim 2019) with steps that flip no
/// triangle (Smith and Schaefer 2015). The boundary is free. Energies are measured at the scale at
/// which the given layout has the least; the layout is scaled to that unless something is fixed.
/// Existing crossings of the boundary may remain; once gone, none may return.
Refinement refine(const DiskChart& chart, std::vector<double> uv, const RefineOptions& options);

/// The energy of a layout at the scale that minimises it.
double energyOf(const DiskChart& chart, const std::vector<double>& uv, const Energy& energy);

/// The stretch of a conformal layout that refining reduces to `stretch`.
double stretchBeforeRefining(double stretch, const Energy& energy);

}  // namespace abflat
