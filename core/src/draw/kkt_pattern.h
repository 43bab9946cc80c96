#pragma once

#include <array>
#include <string>
#include <vector>

#include "abflat/generated/flatten_options.h"
#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat {

/// Rows [begin, end) of the system, which are also its columns.
struct KktBlock {
  std::string name;
  std::size_t begin = 0, end = 0;
};

/// Where the matrix (8) has entries, in the paper's order: Hessian (one row per angle), triangles,
/// interior vertices, wheels, active bounds. Inactive bounds have no row, as in the paper.
struct KktPattern {
  std::size_t size = 0;
  std::vector<KktBlock> blocks;
  std::vector<std::array<std::uint32_t, 2>> entries;  ///< row, column
  std::size_t hessianEntries = 0;
};

/// At the solution for the bound t pi. Errors: those of flatten.
Result<KktPattern> kktPattern(const PolygonMesh& mesh, double t, Formulation formulation);

}  // namespace abflat
