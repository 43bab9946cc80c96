#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "abflat/export.h"
#include "abflat/flatten.h"
#include "abflat/generated/mesh_format.h"
#include "abflat/generated/unwrap_options.h"
#include "abflat/generated/unwrap_report.h"
#include "abflat/mesh.h"
#include "abflat/mesh_view.h"
#include "abflat/pins.h"
#include "abflat/seam_sources.h"

namespace abflat {

/// The result of an earlier run on the same mesh; names as in UnwrapResult.
struct KnownLayout {
  double t = 0;                          ///< its UnwrapOptionValues::t
  double balance = 0;                    ///< likewise
  bool straightSeams = false;            ///< likewise
  std::vector<double> unpacked;          ///< 2 per vertex, where UnwrapResult has texcoords
  std::vector<double> uv;                ///< likewise; for fixedCharts and keepsPlaces
  std::vector<std::uint32_t> vertexMap;  ///< input vertex of each vertex
  std::vector<std::uint32_t> triangles;  ///< 3 vertices per triangle
  std::vector<std::uint32_t> chartOfTriangle;
};

/// What stays as it is in the input or in an earlier run.
struct ReuseOptions {
  /// Charts with the same triangles and outline as one of these are not flattened again, which
  /// makes it cheap to change seams little by little. With straight seams, seams must also end at
  /// the same places along the outline. Empty `triangles`: no earlier layout.
  KnownLayout known;
  /// Charts of `known` that stay exactly where they are, as `fixedFaces` do.
  std::vector<std::uint32_t> fixedCharts;
  /// Charts that need not be flattened again, because they are known, also stay exactly where they
  /// are in `known`. The others are packed around them, at their texel density if there is room.
  /// Charts that stay may overlap or leave their tile; the report then says so.
  bool keepsPlaces = false;
  /// Faces of the input whose uv islands stay exactly as they are; all others are packed around
  /// them. Islands are bounded by edges with different texcoords on their two sides.
  std::vector<std::uint32_t> fixedFaces;
  /// Islands of `fixedFaces` that cannot stay are unwrapped like the others, and a note in the
  /// report names them: where a face is mirrored, degenerate in uv or outside its tile, or where
  /// the island overlaps itself or another one. Otherwise they are an error.
  bool keepsValidOnly = false;
};

struct UnwrapOptions : UnwrapOptionValues {
  SeamSources seams;
  /// Positions in the atlas. Each chart has either no pins or at least two, as in FlattenOptions. A
  /// pinned chart stays where its pins put it, and the others are packed around it.
  std::vector<Pin> pins;
  ReuseOptions reuse;
  /// Per face of the input, the texel density wanted for it relative to the others, from 0.001 to
  /// 1000; empty: 1 each. A chart has as many texels as its faces ask for together. Charts that are
  /// fixed, pinned or stay in their places are left as they are.
  std::vector<double> faceDensities;
  /// To what texcoords are rounded before they are checked. Single precision, which graphics cards
  /// hold, is skipped if it would make a chart invalid; 1 - v is exact in it as well. What a glTF
  /// holds is not skipped.
  Precision precision = Precision::Double;

  /// Newton steps are not reported.
  ProgressCallback progress;
};

/// Tiles are arranged in rows of ten.
inline int tileColumns(const AtlasReport& atlas) { return atlas.tiles < 10 ? atlas.tiles : 10; }
inline int tileRows(const AtlasReport& atlas) { return (atlas.tiles + 9) / 10; }

/// The chart of a face that has no area and touches no other face.
constexpr std::uint32_t kNoChart = 0xffffffffu;

/// Two tables of vertices. The texcoord table is as short as possible; the output vertices are the
/// input vertices, plus one for each further texcoord of a vertex.
struct UnwrapResult {
  std::vector<double> uv;        ///< 2 per texcoord, in the square of a tile
  std::vector<double> unpacked;  ///< the same before packing, at 3D area; NaN for fixed charts
  std::vector<std::uint32_t> cornerUv;  ///< texcoord of each input face corner
  /// Per input face, index into report.charts: the chart of its first triangle, or of a neighbour
  /// if it has no triangle; kNoChart if it has no neighbour either.
  std::vector<std::uint32_t> chartOfFace;
  std::vector<std::uint32_t> vertexMap;     ///< input vertex of each output vertex
  std::vector<std::uint32_t> vertexUv;      ///< texcoord of each output vertex
  std::vector<std::uint32_t> cornerVertex;  ///< output vertex of each input face corner
  /// 3 output vertices per triangle, by input face, as flattened. A face without area gets
  /// triangles without area, so that a triangle mesh keeps all of its triangles in their order.
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> triangleCorners;  ///< the same as face corners of the input
  std::vector<std::uint32_t> chartOfTriangle;
  std::vector<EdgeVertices> seams;  ///< edges that were cut, each listed once
  UnwrapReport report;  ///< the caller fills in path, the read and write times, and the total
};

/// Cuts any mesh into charts, flattens each by its angles and packs them into the unit square, or
/// into as many tiles as needed. The result is valid when every chart is valid and no two overlap.
/// Errors: InvalidOption, InvalidMesh, EmptyMesh, AtlasTooSmall, Aborted.
ABFLAT_API Result<UnwrapResult> unwrap(const PolygonMesh& mesh, const UnwrapOptions& options);

/// The same for triangles in the caller's memory.
ABFLAT_API Result<UnwrapResult> unwrap(const MeshView& mesh, const UnwrapOptions& options);

/// Turns the faces of a mesh that its layout has turned (UnwrapOptions::orient). The corners of the
/// result are those of the changed mesh from then on, so that the two can be written together.
ABFLAT_API void turnFaces(PolygonMesh& mesh, UnwrapResult& result);

/// What a later run can reuse of this one. It is indexed by output vertices, not by texcoords.
ABFLAT_API KnownLayout knownLayout(const UnwrapResult& earlier);

/// The report as JSON text, indented by two spaces; keys as in docs/report.md.
ABFLAT_API std::string unwrapReportJson(const UnwrapReport& report);

}  // namespace abflat
