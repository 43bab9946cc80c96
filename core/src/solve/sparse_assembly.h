#pragma once

#include <Eigen/SparseCore>

#include "solve/sparse_entries.h"

namespace abflat {

/// Square matrix of size n.
Eigen::SparseMatrix<double> assembled(Eigen::Index n, const SparseEntries& entries);

}  // namespace abflat
