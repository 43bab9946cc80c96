#pragma once

#include "solve/solver_choice.h"

namespace abflat {

/// What the options ask for, or why they cannot have it.
Result<SolverChoice> chosenSolver(const FlattenOptions& options);

}  // namespace abflat
