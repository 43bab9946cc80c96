#pragma once

#include <functional>
#include <vector>

#include "abflat/unwrap.h"
#include "hole/filled_table.h"
#include "mesh/surface.h"
#include "mesh/welded_mesh.h"
#include "parallel.h"
#include "unwrap_fixed.h"

namespace abflat {

/// The surface as disks.
struct CutOpen {
  Seams seams;                       ///< those that can be seen, the given ones among them
  FilledTable disks;                 ///< cut open, with what fills holes
  std::vector<std::uint32_t> place;  ///< per vertex of the welded mesh, in an elimination order
};

/// Cuts the surface around what is fixed, and fills the holes of its charts; `keepsOn` as in
/// SeamOptions.
CutOpen cutOpen(const WeldedMesh& welded, const Surface& surface, const Seams& asked,
                const FixedTriangles& fixed, const UnwrapOptions& options, ThreadPool& pool,
                std::function<bool()> keepsOn, SeamSummary& summary);

}  // namespace abflat
