#pragma once

#include <string>
#include <vector>

#include "abflat/unwrap.h"
#include "unwrap/cut_mesh.h"
#include "unwrap/near_parts.h"
#include "unwrap/open_surface.h"
#include "unwrap/packed_charts.h"

namespace abflat {

/// Per chart, where its parts lie nearer to each other in the atlas than the padding. `positions`:
/// of the vertices that charts refer to.
IdVector<ChartId, NearParts> nearPartsOf(const PackedCharts& packed,
                                         const UnwrapOptionValues& options);

/// Cuts charts that have such parts, between them. False if there is none that can be cut.
bool cutBetween(const LaidCharts& charts, const IdVector<ChartId, NearParts>& near,
                const UnwrapOptionValues& options, OpenSurface& open);

/// Says which charts have such parts in the end, and why; empty if none has.
std::string spacingNote(const CutMesh& mesh, const FlatCharts& flat,
                        const IdVector<ChartId, NearParts>& near, const UnwrapOptions& options);

}  // namespace abflat
