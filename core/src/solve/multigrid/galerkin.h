#pragma once

#include "solve/multigrid/half_matrix.h"

namespace abflat {

CompressedRows transposed(const CompressedRows& m, std::uint32_t columns);

/// The diagonal of P' A P and what is right of it, columns ascending. P has `columns` columns.
CompressedRows galerkinProduct(const HalfMatrix& a, const CompressedRows& p, std::uint32_t columns);

}  // namespace abflat
