#pragma once

#include "cut/cut_surface.h"

namespace abflat {

/// Which parts of a surface consist of flat faces at right angles to each other, as what is built
/// of blocks does.
IdVector<CutChartId, std::uint8_t> areBlocks(const SeamMesh& mesh, const CutSurface& parts);

}  // namespace abflat
