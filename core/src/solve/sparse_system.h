#pragma once

#include <vector>

#include "solve/sparse_entries.h"

namespace abflat {

/// A square system of equations with several right-hand sides.
struct SparseSystem {
  int size = 0;
  SparseEntries entries;
  std::vector<double> b;  ///< right-hand sides, one after the other
};

}  // namespace abflat
