#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "abflat/flatten.h"
#include "abflat/generated/unwrap_options.h"
#include "abflat/generated/unwrap_report.h"
#include "abflat/mesh.h"
#include "abflat/pins.h"
#include "abflat/seam_sources.h"

namespace abflat {

/// What an earlier run gave for the same mesh; names as in UnwrapResult.
struct KnownLayout {
  double t = 0;                          ///< its UnwrapOptionValues::t
  double balance = 0;                    ///< likewise
  bool straightSeams = false;            ///< likewise
  std::vector<double> unpacked;          ///< 2 per vertex, where UnwrapResult has texcoords
  std::vector<double> uv;                ///< likewise; only fixedCharts need it
  std::vector<std::uint32_t> vertexMap;  ///< input vertex of each vertex
  std::vector<std::uint32_t> triangles;  ///< 3 vertices per triangle
  std::vector<std::uint32_t> chartOfTriangle;
};

struct UnwrapOptions : UnwrapOptionValues {
  SeamSources seams;
  /// Places in the atlas, of a chart none or two and more, as in FlattenOptions: such a chart stays
  /// where they put it, and the others go around it.
  std::vector<Pin> pins;
  /// Charts that have the triangles and the outline of one of these are not flattened again, which
  /// is for changing seams little by little; with straight seams the ends of seams along it must be
  /// the same, too. No triangles: nothing is known.
  KnownLayout known;
  /// Faces of the input whose uv islands stay exactly as they are; all others are packed around
  /// them. Islands are bounded by edges with different texcoords on their two sides.
  std::vector<std::uint32_t> fixedFaces;
  /// Charts of `known` that stay exactly where they are, likewise.
  std::vector<std::uint32_t> fixedCharts;
  /// Texcoords are rounded to single precision before they are checked, as files and graphics cards
  /// hold them, so that 1 - v is one as well; not where that would make a chart invalid.
  bool roundsToSingle = false;
  /// Texcoords are rounded to what a glTF holds, whatever becomes of the charts: single precision,
  /// with v from the top.
  bool roundsForGltf = false;

  /// Newton steps are not told.
  ProgressCallback progress;
};

/// Tiles beside each other, ten in a row, and rows of them.
inline int tileColumns(const AtlasReport& atlas) { return atlas.tiles < 10 ? atlas.tiles : 10; }
inline int tileRows(const AtlasReport& atlas) { return (atlas.tiles + 9) / 10; }

/// Of a face without area that no other one touches.
constexpr std::uint32_t kNoChart = 0xffffffffu;

/// Two tables of vertices: texcoords are as few as possible, output vertices are input vertices,
/// one more for each further texcoord of theirs.
struct UnwrapResult {
  std::vector<double> uv;        ///< 2 per texcoord, in the square of a tile
  std::vector<double> unpacked;  ///< the same before packing: charts of their 3D area, NaN where
                                 ///< they are fixed
  std::vector<std::uint32_t> cornerUv;  ///< texcoord of each input face corner
  /// Per input face, index into report.charts: that of its first triangle, or of a neighbour where
  /// it has none; kNoChart where it has no neighbour either.
  std::vector<std::uint32_t> chartOfFace;
  std::vector<std::uint32_t> vertexMap;     ///< input vertex of each output vertex
  std::vector<std::uint32_t> vertexUv;      ///< texcoord of each output vertex
  std::vector<std::uint32_t> cornerVertex;  ///< output vertex of each input face corner
  /// 3 output vertices per triangle, by input face: as flattened; of a face without area such
  /// that have none either. So a triangle mesh keeps all of its triangles in their order.
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> triangleCorners;  ///< the same as face corners of the input
  std::vector<std::uint32_t> chartOfTriangle;
  std::vector<EdgeVertices> seams;  ///< edges that were cut, each once
  UnwrapReport report;  ///< path, read and write, and the total are the caller's to fill
};

/// Cuts any mesh into charts, flattens each by its angles and packs them into the unit square, or
/// into as many as it takes. The result is valid when every chart is and none overlap.
/// Errors: InvalidOption, InvalidMesh, EmptyMesh, AtlasTooSmall, Aborted.
Result<UnwrapResult> unwrap(const PolygonMesh& mesh, const UnwrapOptions& options);

/// What a later run may know of this one; rows of the table of vertices, not that of texcoords.
KnownLayout knownLayout(const UnwrapResult& earlier);

/// The report as JSON text, indented by two spaces; keys as in docs/report.md.
std::string unwrapReportJson(const UnwrapReport& report);

}  // namespace abflat
