#pragma once

#include <vector>

#include "base/parallel.h"
#include "pin/flat_region.h"
#include "solve/factor_memory.h"

namespace abflat {

/// Minimises the conformal energy with two or more pinned vertices held where `uv` has them, and
/// replaces the uv of all others. `angles`: see conformalEnergy. False, leaving uv unchanged, if
/// the system is singular to floating-point precision or if, with no factor because of `memory`,
/// the iterations do not converge. Sets the memory that a factor needs. Results do not depend on
/// `pool`; null: one thread.
bool relaxConformally(const FlatRegion& region, const std::vector<double>& angles,
                      const std::vector<ChartVertex>& pinned, std::vector<double>& uv,
                      FactorMemory& memory, ThreadPool* pool = nullptr);

}  // namespace abflat
