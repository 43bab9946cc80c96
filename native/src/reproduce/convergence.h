#pragma once

#include <string>

#include "reproduce/experiment.h"
#include "reproduce/table.h"

namespace abflat::cli {

/// A table with one row per Newton step of each linear solver and formulation, still empty.
Table emptyConvergence();

/// Solves for t = 1 with each linear solver, adds the rows, and returns the plot as an SVG file;
/// empty if the mesh cannot be flattened. Iterative solvers skip meshes that are too large for
/// them, and a row says so.
std::string addConvergence(Table& table, Experiment& experiment, bool precondition);

}  // namespace abflat::cli
