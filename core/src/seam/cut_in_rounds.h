#pragma once

#include <memory>

#include "seam/begin_search.h"

namespace abflat {

/// A mesh whose charts need no more cuts.
struct CutInRounds {
  Seams seams;
  LogScales scale;                   ///< expected
  std::unique_ptr<LogScale> solver;  ///< of the whole mesh; null if the last rounds had only a part
  SeamSteps steps;
};

/// Cuts charts until none needs it. A chart that a round leaves unchanged is done; the rounds
/// continue with only the others as soon as they make up much less than the whole.
/// `solver` is of the mesh, and so are its `ranks`.
CutInRounds cutInRounds(const SeamMesh& mesh, const BegunSearch& begun, const SeamOptions& options,
                        std::unique_ptr<LogScale> solver, const EliminationRanks& ranks);

}  // namespace abflat
