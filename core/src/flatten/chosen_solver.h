#pragma once

#include "abflat/status.h"
#include "solve/solver_choice.h"

namespace abflat {

/// What the options ask for, or why they cannot have it.
Result<SolverChoice> chosenSolver(const FlattenOptionValues& options);

}  // namespace abflat
