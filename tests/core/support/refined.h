#pragma once

#include "abflat/flatten.h"
#include "boundary/chart_flattener.h"
#include "catch.h"
#include "flatten/flatten_chart.h"
#include "refine/refine.h"

namespace abflat::test {

/// A valid layout that keeps the surface's angles as far as possible.
inline std::vector<double> conformalLayout(const DiskChart& chart) {
  ThreadPool pool(1);
  SolverOptions options;
  options.pool = &pool;
  ChartFlattener flattener(chart, options, {true, {}, {}});
  const Attempt a =
      flattenChart(flattener, automaticGoal(BoundaryBounds(chart.boundary.size(), 2)));
  REQUIRE(a.valid());
  return a.uv;
}

inline RefineOptions withBalance(double balance) {
  RefineOptions out;
  out.energy = Energy(balance);
  return out;
}

}  // namespace abflat::test
