#pragma once

#include <vector>

#include "unwrap/flatten_cut.h"
#include "unwrap/stacks.h"

namespace abflat {

/// What the packing of a run needs besides its charts.
struct PackSettings {
  double unit;  ///< what a length of 1 is in the mesh
  std::size_t upAxis;
  /// Of the welded mesh, if that has others meanwhile; otherwise empty.
  const std::vector<double>& truePositions;
  Listener listener;  ///< of packing
};

/// Packs the charts, cuts them where that is worth its seams, and rounds the atlas as its file
/// does. Charts that lie on others may be left out of `surface` and `fixed`. Errors: InvalidOption
/// as in checkPinned, Aborted, and AtlasTooSmall.
Status packCut(const CutFlattener& flattener, const PackSettings& settings, Stacks& stacks,
               Surface& surface, FixedTriangles& fixed, FlatCut& cut, UnwrapReport& report);

}  // namespace abflat
