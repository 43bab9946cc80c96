#pragma once

#include "abflat/unwrap.h"
#include "pin/chart_pins.h"
#include "unwrap/chart.h"
#include "unwrap/cut_mesh.h"

namespace abflat {

RepairReport repairReport(const SurfaceMap& map);

/// Texcoords of the input's corners, one for each vertex of each chart.
Texcoords numberTexcoords(const CutMesh& mesh);

/// How straight what was asked to be straight is where the charts lie in the atlas.
void measureStraight(const ChartSet& set, FlatCharts& flat);

/// Texcoords of the result, from charts that lie in the atlas, which lose theirs. `unit`: what a
/// length of 1 is in the mesh of the user.
void fillTexcoords(const Texcoords& texcoords, double unit, FlatCharts& flat, UnwrapResult& out);

/// What the result says of faces, corners and triangles.
void fillFaces(const CutMesh& mesh, const Texcoords& texcoords, UnwrapResult& out);

/// Charts, means and validity.
void fillReport(const CutMesh& mesh, const FlatCharts& flat, double unit, UnwrapReport& report);

}  // namespace abflat
