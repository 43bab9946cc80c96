#pragma once

#include "abflat/unwrap.h"
#include "chart/chart_set.h"
#include "mesh/welded_mesh.h"
#include "pin/chart_pins.h"
#include "unwrap/chart.h"

namespace abflat {

RepairReport repairReport(const WeldedMesh& welded, const Surface& surface);

/// Where triangles of the surface are in UnwrapResult::triangles, as triangles.
struct TriangleOrder {
  std::vector<std::uint32_t> ofTriangle;   ///< per triangle of the surface
  std::vector<std::uint32_t> firstOfFace;  ///< size F + 1
  std::vector<std::uint8_t> isFolded;      ///< per face: nothing of it is on the surface
};
TriangleOrder triangleOrder(const PolygonMesh& input, const WeldedMesh& welded,
                            const Surface& surface);
/// Texcoords of the input's corners, one for each vertex of each chart.
Texcoords numberTexcoords(const WeldedMesh& welded, const Surface& surface, const ChartSet& set);

/// How straight what was asked to be straight is where the charts lie in the atlas.
void measureStraight(const ChartSet& set, std::vector<FlatChart>& flat);

/// Texcoords of the result, from charts that lie in the atlas, which lose theirs. `unit`: what a
/// length of 1 is in the mesh of the user.
void fillTexcoords(const Texcoords& texcoords, double unit, std::vector<FlatChart>& flat,
                   UnwrapResult& out);

/// What the result says of faces, corners and triangles.
void fillFaces(const PolygonMesh& input, const WeldedMesh& welded, const Surface& surface,
               const ChartSet& set, const Texcoords& texcoords, UnwrapResult& out);

/// Charts, means and validity.
void fillReport(const ChartSet& set, const std::vector<FlatChart>& flat, const Surface& surface,
                const WeldedMesh& welded, double unit, UnwrapReport& report);

}  // namespace abflat
