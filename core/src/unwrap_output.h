#pragma once

#include "abflat/unwrap.h"
#include "chart/chart_set.h"
#include "mesh/welded_mesh.h"
#include "pin/chart_pins.h"
#include "unwrap_chart.h"

namespace abflat {

RepairReport repairReport(const WeldedMesh& welded, const Surface& surface);

/// Texcoords of the input's corners, one for each vertex of each chart.
Texcoords numberTexcoords(const WeldedMesh& welded, const Surface& surface, const ChartSet& set);

/// All of the result but its report, from charts that lie in the atlas.
void fillOutput(const PolygonMesh& input, const WeldedMesh& welded, const Surface& surface,
                const ChartSet& set, const Texcoords& texcoords, const std::vector<FlatChart>& flat,
                UnwrapResult& out);

/// Charts, means and validity.
void fillReport(const ChartSet& set, const std::vector<FlatChart>& flat, const Surface& surface,
                const WeldedMesh& welded, UnwrapReport& report);

}  // namespace abflat
