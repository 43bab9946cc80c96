#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "abflat/generated/flatten_options.h"
#include "abflat/inspect.h"
#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat {

/// Where a run is. `fraction` is a rough 0..1 for progress bars; Newton fields are 0 outside the
/// solve stage.
struct Progress {
  const char* stage = "";  ///< "connectivity", "solve", "layout", "check"
  int newtonStep = 0;
  double constraintResidual = 0;
  double fraction = 0;
};

/// Called often from the calling thread; return false to cancel (the run ends with
/// StatusCode::Aborted).
using ProgressCallback = std::function<bool(const Progress&)>;

/// A bound of t pi for one boundary vertex, in place of the common t. Of several for a vertex the
/// last counts.
struct VertexBound {
  std::uint32_t vertex = 0;  ///< of the input mesh
  double t = 0;
};

/// A part of the boundary that is to be straight in the layout: what follows `from`, with the
/// surface on the left, up to `to`. Both are input vertices and may be corners themselves.
struct StraightRun {
  std::uint32_t from = 0, to = 0;
};

/// Of a pin that needs no face.
constexpr std::uint32_t kAnyFace = 0xffffffffu;

/// The place of a vertex in the layout. Vertex and face are those of the input mesh.
struct Pin {
  std::uint32_t vertex = 0;
  std::array<double, 2> uv{};
  /// One that uses the vertex: tells which of its texcoords is meant where it has several, on both
  /// sides of a seam.
  std::uint32_t face = kAnyFace;
};

struct FlattenOptions : FlattenOptionValues {
  std::vector<VertexBound> bounds;
  /// Angles inside of these are exactly pi, whatever t and the bounds say.
  std::vector<StraightRun> straight;
  /// None, or two and more. Two are met by turning and scaling the layout; of the layouts that meet
  /// more, the nearest to the angles in the sense of least squares is taken.
  std::vector<Pin> pins;
  ProgressCallback progress;
};

/// One step of the solver.
struct NewtonStep {
  double objective = 0;      ///< sum of w (x - a)^2
  double constraint = 0;     ///< largest violation of any constraint, radians (wheels: of the log)
  double gradient = 0;       ///< largest |dL/dx| relative to the largest weight times angle
  std::uint32_t active = 0;  ///< boundary vertices held at their bound
  std::uint32_t activeEdges = 0;  ///< interior edges held at the Delaunay limit
  double step = 0;                ///< step length in (0, 1]
  /// Angles that the full step would take to 0 or pi: they make it shorter and weigh more from now
  /// on.
  std::uint32_t reweighted = 0;
  int linearIterations = 0;  ///< of the linear solver; 0 when it is direct
  double linearSeconds = 0;  ///< spent on the linear system
};

/// What became of condition (9). Vertices are those of the input mesh.
struct DelaunayReport {
  std::size_t edges = 0;           ///< interior edges
  std::size_t violatedBefore = 0;  ///< edges that were not Delaunay, by an exact in-circle test
  std::size_t violated = 0;        ///< of the result; 0: the layout is a Delaunay triangulation
  double angularDistortionBefore = 0;
  /// Edges that stay violated when the condition is met as far as possible.
  std::vector<std::array<std::uint32_t, 2>> resisting;
};

/// What refining for lengths did, see FlattenOptions::balance. Energies are means over the surface
/// of (1 - b) (s1/s2 + s2/s1)/2 + b (s1^2 + s2^2 + s1^-2 + s2^-2)/4 with b the balance and s1, s2
/// the singular values of the map from the surface, at the scale of least energy unless pins give
/// one: 1 at best.
struct RefineReport {
  double energyBefore = 1;  ///< of the layout that the angles give
  double energy = 1;
  int steps = 0;      ///< of Newton's method
  std::string limit;  ///< what stood in the way of less energy, one sentence; empty: nothing
};

/// What became of pins.
struct PinReport {
  std::size_t count = 0;
  /// Largest distance in uv from a pin to where the layout has its vertex without pins, once that
  /// is moved, turned and scaled to fit them best; 0 for two pins.
  double deviation = 0;
};

/// What became of straight runs.
struct StraightReport {
  std::size_t runs = 0;
  std::size_t vertices = 0;  ///< strictly inside of them, each with an angle of pi
  /// Vertices that were not held straight because no layout, or none without much distortion, has
  /// all of them.
  std::size_t released = 0;
  double deviation = 0;  ///< largest difference from pi of the layout's angle at one, radians
};

struct ChartReport {
  std::size_t faces = 0;
  std::size_t boundaryVertices = 0;
  double t = 0;
  std::vector<VertexBound> bounds;  ///< boundary vertices with a bound below t, as used
  std::string solver;               ///< "activeSet", "interiorPoint" or "tutte"
  std::string linearSolver;         ///< "schur", "minres", "symmlq", "gmres" or "bicgstab"
  std::string formulation;          ///< "log" or "product"
  int iterations = 0;
  std::vector<NewtonStep> history;
  double constraintResidual = 0;
  bool converged = false;
  double angularDistortion = 0;  ///< mean over corners of ((x - alpha)/alpha)^2
  double lengthDistortion = 0;   ///< mean over edges of (s L/l - 1)^2, s = sum l / sum L
  double quasiConformalMean = 0, quasiConformalMax = 0;  ///< ratio of singular values, >= 1
  double stretchL2 = 0, stretchLinf = 0;                ///< Sander et al. 2001, at equal total area
  double symmetricDirichlet = 0;                        ///< divided by 4: 1 is an isometry
  double areaDistortionMin = 0, areaDistortionMax = 0;  ///< uv area / 3D area at equal total area
  std::size_t degenerateTriangles =
      0;  ///< of zero area in 3D: their targets are made up, they count in no distortion
  std::size_t flippedTriangles = 0;  ///< not positively oriented, by an exact predicate
  std::size_t boundaryCrossings =
      0;  ///< pairs of boundary edges that cross or touch, by an exact predicate
  double maxBoundaryAngle = 0;             ///< radians
  std::optional<DelaunayReport> delaunay;  ///< when it was asked for
  std::optional<RefineReport> refined;     ///< when it was asked for, of a valid layout
  std::optional<PinReport> pins;           ///< when there are any
  std::optional<StraightReport> straight;  ///< when it was asked for
  std::vector<std::string> fallbacks;  ///< what was done beyond the plain solver, one sentence each
  std::string problem;  ///< why the chart is not valid, one sentence; empty when it is
  bool valid = false;
};

/// Seconds.
struct Timings {
  double read = 0, connectivity = 0, solve = 0, layout = 0, refine = 0, check = 0, write = 0,
         total = 0;
};

struct Report {
  std::string path;
  MeshSummary input;
  FlattenOptionValues options;  ///< as asked
  std::vector<ChartReport> charts;
  unsigned threads = 1;  ///< that the solver used
  bool valid = false;
  Timings timings;
  Status error;  ///< why there is no result; ok when there is one
};

struct FlattenResult {
  std::vector<double> uv;  ///< 2 per output vertex; of the mesh's 3D area unless pinned
  std::vector<std::uint32_t> vertexMap;  ///< input vertex of each output vertex
  std::vector<std::uint32_t> triangles;  ///< 3 output vertices per triangle (polygons triangulated)
  std::vector<std::uint32_t>
      cornerUv;  ///< output vertex of each input face corner (size of faceVertices)
  std::vector<std::uint32_t> straight;  ///< output vertices whose angle was held at pi
  Report report;  ///< path and timings.read/write/total are the caller's to fill
};

/// Flattens a mesh that is one topological disk (paper, section 5, with bounds t*pi on the
/// boundary). A result that is not valid or did not converge is still returned, with report.valid =
/// false. Errors: InvalidOption, InvalidMesh, EmptyMesh, DegenerateFace, NonManifoldEdge,
/// InconsistentOrientation, MultipleComponents, ClosedSurface, MultipleBoundaryLoops, HasHandles,
/// InfeasibleBound, Aborted.
Result<FlattenResult> flatten(const PolygonMesh& mesh, const FlattenOptions& options);

/// Rounds a valid layout to single precision, which is all that many programs read from a PLY file,
/// and measures it again: the report is about the rounded coordinates then. Where that would flip a
/// triangle, make the boundary cross itself or lose the Delaunay condition, the layout stays as it
/// is and a sentence among the fallbacks says so. Returns whether it was rounded.
bool roundToSinglePrecision(const PolygonMesh& mesh, FlattenResult& result);

/// Rounds a layout to what a glTF holds, whatever becomes of it: single precision, with v from the
/// top. The report is about the rounded coordinates then.
void roundForGltf(const PolygonMesh& mesh, FlattenResult& result);

/// The report as JSON text, indented by two spaces; keys as in the README. Numbers that are not
/// finite, and counts of an input that is not known (it could not be read), are null.
std::string reportJson(const Report& report);

}  // namespace abflat
