#pragma once

#include "abflat/status.h"
#include "solve/solver_choice.h"

namespace abflat {

/// The solver that the options ask for, or the reason why it cannot be used.
Result<SolverChoice> chosenSolver(const FlattenOptionValues& options);

}  // namespace abflat
