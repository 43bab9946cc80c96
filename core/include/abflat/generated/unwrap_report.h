// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "abflat/generated/baking_report.h"
#include "abflat/generated/chart_report.h"
#include "abflat/generated/mesh_summary.h"
#include "abflat/generated/names.h"
#include "abflat/generated/unwrap_options.h"
#include "abflat/status.h"

namespace abflat {

/// Repairs made to find the surface, for unwrapping only: the mesh itself is not changed; faces and
/// vertices are those of the input.
struct RepairReport {
  /// Duplicate vertices, treated as one vertex of the surface.
  std::size_t mergedVertices = 0;
  /// Faces without area, such as those with fewer than three distinct corners, and slivers whose
  /// short edge is too short to be seen; they get the uv of a face beside them.
  std::vector<std::uint32_t> collapsedFaces;
  /// Faces that touch themselves or list a corner twice.
  std::vector<std::uint32_t> splitFaces;
  /// Faces that repeat an earlier one, the second number; they become charts of their own.
  std::vector<std::array<std::uint32_t, 2>> duplicateFaces;
  /// Edges with more than two faces, by their vertices; all but the faces that continue each other
  /// were cut off.
  std::vector<std::array<std::uint32_t, 2>> nonManifoldEdges;
  /// Edges whose two faces run in the same direction, by their vertices; they were cut.
  std::vector<std::array<std::uint32_t, 2>> orientationConflicts;
  /// Faces that were turned to run like their neighbours (orient).
  std::vector<std::uint32_t> turnedFaces;
  /// Triangles of zero area, whose angles are made up.
  std::size_t degenerateTriangles = 0;
};

template <class Visitor>
void visitFields(const RepairReport& r, Visitor& v) {
  v.field("mergedVertices", r.mergedVertices);
  v.field("collapsedFaces", r.collapsedFaces);
  v.field("splitFaces", r.splitFaces);
  v.field("duplicateFaces", r.duplicateFaces);
  v.field("nonManifoldEdges", r.nonManifoldEdges);
  v.field("orientationConflicts", r.orientationConflicts);
  v.field("turnedFaces", r.turnedFaces);
  v.field("degenerateTriangles", r.degenerateTriangles);
}

/// Where the surface was cut, beyond its boundary.
struct SeamSummary {
  /// Edges that were cut.
  std::size_t edges = 0;
  /// Length of these edges, divided by the square root of the mesh's area.
  double relativeLength = 0;
  /// Genus of the surface, summed over components; -1 if it was cut because it is not manifold.
  std::int64_t genus = 0;
  /// Loops cut to open handles, two per handle.
  std::size_t handleLoops = 0;
  /// Length of these loops and of the other cuts that make each component a disk, divided by the
  /// square root of the area.
  double handleLength = 0;
  /// Boundary loops in charts that no seam joins to the outer boundary.
  std::size_t filledHoles = 0;
  /// Whether seams on the two sides of a plane mirror each other, as far as the mesh does.
  bool symmetric = false;
};

template <class Visitor>
void visitFields(const SeamSummary& r, Visitor& v) {
  v.field("edges", r.edges);
  v.field("relativeLength", r.relativeLength);
  v.field("genus", r.genus);
  v.field("handleLoops", r.handleLoops);
  v.field("handleLength", r.handleLength);
  v.field("filledHoles", r.filledHoles);
  v.field("symmetric", r.symmetric);
}

/// A chart of unwrap; its measures are at the chart's own scale.
struct UnwrapChart {
  /// Triangles of the chart.
  std::size_t faces = 0;
  /// A face of the input that is in it.
  std::uint32_t firstFace = 0;
  /// Vertices of its outer boundary.
  std::size_t boundaryVertices = 0;
  /// Holes that are treated as filled.
  std::size_t filledHoles = 0;
  /// Area in 3D.
  double area = 0;
  /// What it looks like.
  ChartShape shape = ChartShape::Other;
  /// What made the layout.
  Solver solver = Solver::ActiveSet;
  /// Whether it stays where the input, an earlier run or pins put it.
  bool fixed = false;
  /// The chart that it lies on, whose texels it shares; -1 if it has texels of its own.
  int stackedOn = -1;
  /// Whether it lies there mirrored, so that its triangles run clockwise.
  bool mirrored = false;
  /// Newton steps of the last solve.
  int iterations = 0;
  /// Mean over corners of ((x - α)/α)², with x the angle in uv and α that in 3D.
  double angularDistortion = 0;
  /// Ratio σ₁/σ₂ of the singular values of the map (1 = conformal): mean by 3D area.
  double quasiConformalMean = 0;
  /// Ratio σ₁/σ₂ of the singular values of the map (1 = conformal): maximum.
  double quasiConformalMax = 0;
  /// Ratio σ₁/σ₂ of the singular values of the map (1 = conformal): share of the 3D area where it
  /// exceeds 1.25.
  double quasiConformalSheared = 0;
  /// Mean by 3D area of (σ₁² + σ₂² + σ₁⁻² + σ₂⁻²)/4 (1 = isometric).
  double symmetricDirichlet = 0;
  /// How many times as far above 1 as maxStretch its stretch may be: frontLeeway in the front of a
  /// figure, less where only a part is, more on a mask without a seam.
  double leeway = 1;
  /// The outcome of refining for lengths; of the whole chart if packing has cut it.
  std::optional<RefineReport> refined;
  /// How the pins were met.
  std::optional<PinReport> pins;
  /// How straight the runs are.
  std::optional<StraightReport> straight;
  /// What was done beyond the plain solver, one sentence each.
  std::vector<std::string> fallbacks;
  /// Why the chart is not valid, one sentence; empty when it is.
  std::string problem;
  /// Whether the chart is valid and the solver converged.
  bool valid = false;
};

template <class Visitor>
void visitFields(const UnwrapChart& r, Visitor& v) {
  v.field("faces", r.faces);
  v.field("firstFace", r.firstFace);
  v.field("boundaryVertices", r.boundaryVertices);
  v.field("filledHoles", r.filledHoles);
  v.field("area", r.area);
  v.field("shape", r.shape);
  v.field("solver", r.solver);
  v.field("fixed", r.fixed);
  v.field("stackedOn", r.stackedOn);
  v.field("mirrored", r.mirrored);
  v.field("iterations", r.iterations);
  v.field("angularDistortion", r.angularDistortion);
  v.begin("quasiConformal");
  v.field("mean", r.quasiConformalMean);
  v.field("max", r.quasiConformalMax);
  v.field("sheared", r.quasiConformalSheared);
  v.end();
  v.field("symmetricDirichlet", r.symmetricDirichlet);
  v.field("leeway", r.leeway);
  v.field("refined", r.refined);
  v.field("pins", r.pins);
  v.field("straight", r.straight);
  v.field("fallbacks", r.fallbacks);
  v.field("problem", r.problem);
  v.field("valid", r.valid);
}

/// How the charts were packed.
struct AtlasReport {
  /// Texels along the longer side of a tile.
  int resolution = 0;
  /// Texels of a tile from u = 0 to 1.
  int width = 0;
  /// Texels of a tile from v = 0 to 1.
  int height = 0;
  /// Texels between charts.
  int padding = 0;
  /// Texels between charts and the edge of their tile.
  int margin = 0;
  /// Unit squares, ten in a row: UDIM 1001 and on.
  int tiles = 1;
  /// Share of the tiles that charts cover; what charts share counts once.
  double utilization = 0;
  /// Charts that lie on others of the same shape (stack): how many lie on others.
  int stackedCharts = 0;
  /// Charts that lie on others of the same shape (stack): on how many others they lie.
  int stackedPlaces = 0;
  /// Charts that lie on others of the same shape (stack): how many of them are mirrored.
  int stackedMirrored = 0;
  /// Texels per mesh unit, for faces without a density of their own.
  double texelDensity = 0;
  /// Charts that were cut in two so that all pack tighter.
  int packingCuts = 0;
  /// Length of these cuts, divided by the square root of the area.
  double packingCutLength = 0;
  /// Texel density without them; 0 if there are none.
  double uncutTexelDensity = 0;
};

template <class Visitor>
void visitFields(const AtlasReport& r, Visitor& v) {
  v.field("resolution", r.resolution);
  v.field("width", r.width);
  v.field("height", r.height);
  v.field("padding", r.padding);
  v.field("margin", r.margin);
  v.field("tiles", r.tiles);
  v.field("utilization", r.utilization);
  v.begin("stacked");
  v.field("charts", r.stackedCharts);
  v.field("places", r.stackedPlaces);
  v.field("mirrored", r.stackedMirrored);
  v.end();
  v.field("texelDensity", r.texelDensity);
  v.field("packingCuts", r.packingCuts);
  v.field("packingCutLength", r.packingCutLength);
  v.field("uncutTexelDensity", r.uncutTexelDensity);
}

/// One number for each stage of unwrap.
struct UnwrapStages {
  /// Reading the input.
  double read = 0;
  /// Finding the surface in the mesh.
  double surface = 0;
  /// Choosing seams.
  double seams = 0;
  /// Flattening: the angles alone, or in unwrap all of it.
  double solve = 0;
  /// Packing the charts.
  double pack = 0;
  /// Checking and measuring the result.
  double check = 0;
  /// Writing the result.
  double write = 0;
};

template <class Visitor>
void visitFields(const UnwrapStages& r, Visitor& v) {
  v.field("read", r.read);
  v.field("surface", r.surface);
  v.field("seams", r.seams);
  v.field("solve", r.solve);
  v.field("pack", r.pack);
  v.field("check", r.check);
  v.field("write", r.write);
}

/// Seconds that each stage of unwrap took.
struct UnwrapTimings : UnwrapStages {
  /// The whole run, in seconds.
  double total = 0;
};

template <class Visitor>
void visitFields(const UnwrapTimings& r, Visitor& v) {
  visitFields(static_cast<const UnwrapStages&>(r), v);
  v.field("total", r.total);
}

/// The report of unwrap.
struct UnwrapReport {
  /// Name of the input.
  std::string path;
  /// The input.
  MeshSummary input;
  /// The options as asked.
  UnwrapOptionValues options;
  /// Threads that the solver used.
  std::uint32_t threads = 1;
  /// Repairs made to find the surface.
  RepairReport repair;
  /// Where the surface was cut.
  SeamSummary seams;
  /// One entry per chart.
  std::vector<UnwrapChart> charts;
  /// Where the result differs from what was asked, and other remarks, one sentence each.
  std::vector<std::string> notes;
  /// Angular distortion, the mean over all charts by 3D area.
  double angularDistortion = 0;
  /// Quasi-conformal distortion σ₁/σ₂, the mean over all charts by 3D area.
  double quasiConformalMean = 0;
  /// Share of the 3D area where σ₁/σ₂ exceeds 1.25.
  double sheared = 0;
  /// Symmetric Dirichlet energy / 4, the mean over all charts by 3D area, each chart at its own
  /// scale.
  double symmetricDirichlet = 0;
  /// How the charts were packed.
  AtlasReport atlas;
  /// Whether every chart is valid and none overlap.
  bool valid = false;
  /// Seconds that each stage took.
  UnwrapTimings timings;
  /// Peak memory in MB by the end of each stage: natively of the process, in the package of the
  /// module's heap, which never shrinks, in MB.
  UnwrapStages peakMemory;
  /// What became of the old textures.
  std::optional<BakingReport> baking;
  /// Why there is no result.
  Status error;
};

template <class Visitor>
void visitFields(const UnwrapReport& r, Visitor& v) {
  v.inputSummary("input", r);
  v.options("options", r.options);
  v.field("threads", r.threads);
  v.field("repair", r.repair);
  v.field("seams", r.seams);
  v.field("charts", r.charts);
  v.field("notes", r.notes);
  v.field("angularDistortion", r.angularDistortion);
  v.field("quasiConformalMean", r.quasiConformalMean);
  v.field("sheared", r.sheared);
  v.field("symmetricDirichlet", r.symmetricDirichlet);
  v.field("atlas", r.atlas);
  v.field("valid", r.valid);
  v.field("timings", r.timings);
  v.field("peakMemory", r.peakMemory);
  if (r.baking) v.field("baking", *r.baking);
  v.reportError("error", r.error);
}

}  // namespace abflat
