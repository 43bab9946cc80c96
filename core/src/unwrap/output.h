#pragma once

#include "abflat/unwrap.h"
#include "pin/chart_pins.h"
#include "unwrap/chart.h"
#include "unwrap/cut_mesh.h"

namespace abflat {

RepairReport repairReport(const SurfaceMap& map);

/// Texcoords of the input's corners, one for each vertex of each chart.
Texcoords numberTexcoords(const CutMesh& mesh);

/// Measures, in the atlas, how straight the parts are that were asked to be straight.
void measureStraight(const ChartSet& set, FlatCharts& flat);

/// Moves the texcoords of charts that lie in the atlas to the result. `unit`: what a length of 1 is
/// in the user's mesh.
void fillTexcoords(const Texcoords& texcoords, double unit, FlatCharts& flat, UnwrapResult& out);

/// Fills in the result's faces, corners and triangles.
void fillFaces(const CutMesh& mesh, const Texcoords& texcoords, UnwrapResult& out);

/// Fills in charts, means and validity.
void fillReport(const CutMesh& mesh, const FlatCharts& flat, double unit, UnwrapReport& report);

}  // namespace abflat
