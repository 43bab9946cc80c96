#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "abflat/export.h"
#include "abflat/generated/mesh_format.h"
#include "abflat/generated/names.h"
#include "abflat/generated/pack_options.h"
#include "abflat/generated/pack_report.h"
#include "abflat/mesh.h"
#include "abflat/progress.h"

namespace abflat {

struct PackLayoutOptions : PackOptionValues {
  /// Only these islands are packed, around the others, which stay where they are, inside of tiles
  /// or not. They do not grow. Empty: all are packed.
  std::vector<std::uint32_t> islands;
  /// Per island, the tile that it goes to: 0 is UDIM 1001, and a row has ten. Each tile is packed
  /// by itself, as tight as it can be. Needs no udim. Empty: one tile for all.
  std::vector<std::uint32_t> tileOfIsland;
  /// To what texcoords are rounded before they are checked.
  Precision precision = Precision::Double;
  ProgressCallback progress;
};

/// Stands for the island of a face without texcoords.
constexpr std::uint32_t kNoIsland = 0xffffffffu;

struct PackLayoutResult {
  /// 2 per texcoord: those of the mesh that faces use, in their order, then one more where islands
  /// that have moved apart shared one.
  std::vector<double> uv;
  std::vector<std::uint32_t> cornerUv;         ///< per face corner, or kNoTexcoord
  std::vector<std::uint32_t> islandOfFace;     ///< or kNoIsland
  std::vector<std::uint32_t> triangleCorners;  ///< 3 face corners per triangle, by face
  std::vector<std::uint8_t> faults;            ///< per triangle, a sum of the bits of UvFault
  PackReport report;  ///< the caller fills in path, the read and write times, and the total
};

/// Packs the layout that a mesh has: its uv islands are moved, turned and scaled, and otherwise
/// stay as they are. Islands that lie on each other, by half of the smaller one or more, move
/// together. Any layout will do: islands may be mirrored, overlap themselves, or lie anywhere. With
/// `keepPlaces` nothing moves, and the layout is only judged.
/// Errors: InvalidOption, InvalidMesh, EmptyMesh, NoTexcoords, AtlasTooSmall, Aborted.
ABFLAT_API Result<PackLayoutResult> packLayout(const PolygonMesh& mesh,
                                               const PackLayoutOptions& options);

/// Gives the mesh other texcoords: 2 per corner of its triangles, in the order of
/// `triangleCorners`. Faces without texcoords stay without. Errors: InvalidMesh.
ABFLAT_API Status replaceTexcoords(PolygonMesh& mesh, const std::vector<double>& triangleUv);

/// The layout with one texcoord per vertex, as graphics cards take it.
struct PackedVertices {
  /// Vertex of the mesh that each repeats: all of them in their order, then a copy for every
  /// further texcoord that a vertex has.
  std::vector<std::uint32_t> vertexMap;
  std::vector<double> uv;                       ///< 2 per vertex; 0 where no face has any
  std::vector<std::uint32_t> triangles;         ///< 3 vertices per triangle, by face
  std::vector<std::uint32_t> islandOfTriangle;  ///< or kNoIsland
};
ABFLAT_API PackedVertices packedVertices(const PolygonMesh& mesh, const PackLayoutResult& result);

/// The report as JSON text, indented by two spaces; keys as in docs/report.md.
ABFLAT_API std::string packReportJson(const PackReport& report);

}  // namespace abflat
