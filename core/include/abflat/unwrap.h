#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "abflat/flatten.h"
#include "abflat/generated/unwrap_options.h"
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

/// What was done to see the surface in the mesh. The mesh itself keeps all of it. Faces and
/// vertices are those of the input.
struct RepairReport {
  std::size_t mergedVertices = 0;  ///< at the place of another one: one vertex of the surface
  std::vector<std::uint32_t> collapsedFaces;  ///< fewer than three places: uv of their neighbours
  std::vector<std::uint32_t> splitFaces;      ///< touch themselves: split there
  /// Have the places of an earlier one (the second number): charts of their own.
  std::vector<std::array<std::uint32_t, 2>> duplicateFaces;
  /// Edges of more than two faces, by their vertices: cut.
  std::vector<EdgeVertices> nonManifoldEdges;
  /// Edges whose two faces run in the same direction, by their vertices: cut.
  std::vector<EdgeVertices> orientationConflicts;
  std::size_t degenerateTriangles = 0;  ///< of zero area: their angles are made up
};

/// Where the surface was cut, beyond its boundary.
struct SeamSummary {
  std::size_t edges = 0;
  double relativeLength = 0;    ///< divided by the root of the mesh's area
  std::int64_t genus = 0;       ///< of the surface, summed over components; -1 where it is cut
                                ///< because it is no manifold
  std::size_t handleLoops = 0;  ///< two for each handle
  double handleLength = 0;      ///< of these loops and of what else makes each component a disk,
                                ///< divided by the root of the area
  std::size_t filledHoles = 0;  ///< boundary loops in charts that no seam joins to the outer one
};

/// A chart as a row of a table; measures as in ChartReport, at the chart's own scale.
struct UnwrapChart {
  std::size_t faces = 0;             ///< triangles
  std::uint32_t firstFace = 0;       ///< an input face in it
  std::size_t boundaryVertices = 0;  ///< of the outer boundary
  std::size_t filledHoles = 0;
  double area = 0;  ///< 3D
  Solver solver = Solver::ActiveSet;
  bool fixed = false;  ///< stays where the input or pins put it
  int iterations = 0;
  double angularDistortion = 0, quasiConformalMean = 0, quasiConformalMax = 0,
         symmetricDirichlet = 0;
  std::optional<RefineReport> refined;     ///< where refining gained something
  std::optional<PinReport> pins;           ///< when there are any
  std::optional<StraightReport> straight;  ///< when it was asked for
  std::vector<std::string> fallbacks;
  std::string problem;
  bool valid = false;
};

struct AtlasReport {
  int resolution = 0;            ///< texels along a side
  int padding = 0;               ///< texels
  int tiles = 1;                 ///< unit squares, ten in a row: UDIM 1001 and on
  double utilization = 0;        ///< uv area of the charts, of that of the tiles
  double texelDensity = 0;       ///< texels per unit of length of the mesh
  int packingCuts = 0;           ///< charts that were cut in two so that all are packed denser
  double packingCutLength = 0;   ///< of these seams, over the root of the area
  double uncutTexelDensity = 0;  ///< without them; 0 where there are none

  int columns() const { return tiles < 10 ? tiles : 10; }
  int rows() const { return (tiles + 9) / 10; }
};

/// One number for each stage.
struct UnwrapStages {
  double read = 0, surface = 0, seams = 0, solve = 0, pack = 0, check = 0, write = 0;
};

/// Seconds.
struct UnwrapTimings : UnwrapStages {
  double total = 0;
};

struct UnwrapReport {
  std::string path;
  MeshSummary input;
  UnwrapOptionValues options;  ///< as asked
  RepairReport repair;
  SeamSummary seams;
  std::vector<UnwrapChart> charts;
  std::vector<std::string> notes;  ///< what was done otherwise than asked, one sentence each
  /// Means over all charts by 3D area, at one common scale.
  double angularDistortion = 0, quasiConformalMean = 0, symmetricDirichlet = 0;
  AtlasReport atlas;
  unsigned threads = 1;
  bool valid = false;
  UnwrapTimings timings;
  UnwrapStages
      peakMemory;  ///< by the end of each stage, see peakMemory(); 0 where a run ended before
  Status error;    ///< why there is no result; ok when there is one
};

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
