// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "abflat/generated/flatten_options.h"
#include "abflat/generated/names.h"
#include "abflat/generated/newton_step.h"
#include "abflat/generated/vertex_bound.h"

namespace abflat {

/// The outcome of the Delaunay condition (9).
struct DelaunayReport {
  /// Interior edges.
  std::size_t edges = 0;
  /// Edges that were not Delaunay, by an exact in-circle test.
  std::size_t violatedBefore = 0;
  /// Edges that are not Delaunay in the result; with 0 the layout is a Delaunay triangulation.
  std::size_t violated = 0;
  /// Angular distortion without the condition.
  double angularDistortionBefore = 0;
  /// Edges, as two vertices of the input, that stay violated when the condition is met as far as
  /// possible.
  std::vector<std::array<std::uint32_t, 2>> resisting;
};

template <class Visitor>
void visitFields(const DelaunayReport& r, Visitor& v) {
  v.field("edges", r.edges);
  v.field("violatedBefore", r.violatedBefore);
  v.field("violated", r.violated);
  v.field("angularDistortionBefore", r.angularDistortionBefore);
  v.field("resisting", r.resisting);
}

/// The outcome of refining for lengths; energies are means over the surface of (1 - b)(σ₁/σ₂ +
/// σ₂/σ₁)/2 + b(σ₁² + σ₂² + σ₁⁻² + σ₂⁻²)/4, where b is the balance and σ₁, σ₂ are the singular
/// values of the map from the surface, at the scale of least energy unless pins give one: 1 at
/// best.
struct RefineReport {
  /// Energy of the layout that the angles give.
  double energyBefore = 1;
  /// Energy of the result.
  double energy = 1;
  /// Steps of Newton's method.
  int steps = 0;
  /// What prevented a lower energy, one sentence; empty if nothing did.
  std::string limit;
};

template <class Visitor>
void visitFields(const RefineReport& r, Visitor& v) {
  v.field("energyBefore", r.energyBefore);
  v.field("energy", r.energy);
  v.field("steps", r.steps);
  v.field("limit", r.limit);
}

/// How the pins were met.
struct PinReport {
  /// Number of pins.
  std::size_t count = 0;
  /// Largest distance in uv from a pin to its vertex in the layout without pins, once that layout
  /// is moved, rotated and scaled to fit them best; 0 for two pins.
  double deviation = 0;
};

template <class Visitor>
void visitFields(const PinReport& r, Visitor& v) {
  v.field("count", r.count);
  v.field("deviation", r.deviation);
}

/// How straight the runs are.
struct StraightReport {
  /// Number of runs.
  std::size_t runs = 0;
  /// Vertices strictly inside of them, each with an angle of π.
  std::size_t vertices = 0;
  /// Vertices that were not held straight because no layout, or none without much distortion, has
  /// all of them straight.
  std::size_t released = 0;
  /// Largest difference of such an angle from π in the layout, in radians.
  double deviation = 0;
};

template <class Visitor>
void visitFields(const StraightReport& r, Visitor& v) {
  v.field("runs", r.runs);
  v.field("vertices", r.vertices);
  v.field("released", r.released);
  v.field("deviation", r.deviation);
}

/// A chart of flatten.
struct ChartReport {
  /// Triangles of the chart.
  std::size_t faces = 0;
  /// Vertices on its boundary.
  std::size_t boundaryVertices = 0;
  /// The largest bound used; 2 and above is a free boundary.
  double t = 0;
  /// Boundary vertices with a bound below t, as used.
  std::vector<VertexBound> bounds;
  /// What made the layout.
  Solver solver = Solver::ActiveSet;
  /// The linear solver that was used.
  LinearSolver linearSolver = LinearSolver::Schur;
  /// The form of the wheel condition that was used.
  Formulation formulation = Formulation::Log;
  /// Newton steps of the last solve.
  int iterations = 0;
  /// These steps.
  std::vector<NewtonStep> history;
  /// Largest violation of any constraint at the end.
  double constraintResidual = 0;
  /// Whether the tolerances were met.
  bool converged = false;
  /// Mean over corners of ((x - α)/α)², with x the angle in uv and α that in 3D.
  double angularDistortion = 0;
  /// Mean over edges of (sL/l - 1)², with L the length in uv, l that in 3D and s = Σl/ΣL.
  double lengthDistortion = 0;
  /// Ratio σ₁/σ₂ of the singular values of the map (1 = conformal): mean by 3D area.
  double quasiConformalMean = 0;
  /// Ratio σ₁/σ₂ of the singular values of the map (1 = conformal): maximum.
  double quasiConformalMax = 0;
  /// Ratio σ₁/σ₂ of the singular values of the map (1 = conformal): share of the 3D area where it
  /// exceeds 1.25.
  double quasiConformalSheared = 0;
  /// Stretch of Sander et al. 2001 at equal total area (1 = isometric): L² stretch.
  double stretchL2 = 0;
  /// Stretch of Sander et al. 2001 at equal total area (1 = isometric): L∞ stretch.
  double stretchLinf = 0;
  /// Mean by 3D area of (σ₁² + σ₂² + σ₁⁻² + σ₂⁻²)/4 (1 = isometric).
  double symmetricDirichlet = 0;
  /// Ratio of uv area to 3D area at equal total area: minimum.
  double areaDistortionMin = 0;
  /// Ratio of uv area to 3D area at equal total area: maximum.
  double areaDistortionMax = 0;
  /// Triangles of zero area in 3D: their target angles are made up, and no distortion counts them.
  std::size_t degenerateTriangles = 0;
  /// Triangles that are not positively oriented, by an exact predicate; 0 in a valid layout.
  std::size_t flippedTriangles = 0;
  /// Pairs of boundary edges that cross or touch, by an exact predicate; 0 in a valid layout.
  std::size_t boundaryCrossings = 0;
  /// Largest interior angle of the layout's boundary, in radians.
  double maxBoundaryAngle = 0;
  /// The outcome of the Delaunay condition.
  std::optional<DelaunayReport> delaunay;
  /// The outcome of refining for lengths.
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
void visitFields(const ChartReport& r, Visitor& v) {
  v.field("faces", r.faces);
  v.field("boundaryVertices", r.boundaryVertices);
  v.field("t", r.t);
  v.field("bounds", r.bounds);
  v.field("solver", r.solver);
  v.field("linearSolver", r.linearSolver);
  v.field("formulation", r.formulation);
  v.field("iterations", r.iterations);
  v.field("history", r.history);
  v.field("constraintResidual", r.constraintResidual);
  v.field("converged", r.converged);
  v.field("angularDistortion", r.angularDistortion);
  v.field("lengthDistortion", r.lengthDistortion);
  v.begin("quasiConformal");
  v.field("mean", r.quasiConformalMean);
  v.field("max", r.quasiConformalMax);
  v.field("sheared", r.quasiConformalSheared);
  v.end();
  v.begin("stretch");
  v.field("l2", r.stretchL2);
  v.field("linf", r.stretchLinf);
  v.end();
  v.field("symmetricDirichlet", r.symmetricDirichlet);
  v.begin("areaDistortion");
  v.field("min", r.areaDistortionMin);
  v.field("max", r.areaDistortionMax);
  v.end();
  v.field("degenerateTriangles", r.degenerateTriangles);
  v.field("flippedTriangles", r.flippedTriangles);
  v.field("boundaryCrossings", r.boundaryCrossings);
  v.field("maxBoundaryAngle", r.maxBoundaryAngle);
  v.field("delaunay", r.delaunay);
  v.field("refined", r.refined);
  v.field("pins", r.pins);
  v.field("straight", r.straight);
  v.field("fallbacks", r.fallbacks);
  v.field("problem", r.problem);
  v.field("valid", r.valid);
}

/// Seconds that each stage of flatten took.
struct Timings {
  /// Reading the input, in seconds.
  double read = 0;
  /// Finding the surface and its boundary, in seconds.
  double connectivity = 0;
  /// Flattening: the angles alone, or in unwrap all of it, in seconds.
  double solve = 0;
  /// Turning angles into positions, in seconds.
  double layout = 0;
  /// Trading angles for lengths, in seconds.
  double refine = 0;
  /// Checking and measuring the result, in seconds.
  double check = 0;
  /// Writing the result, in seconds.
  double write = 0;
  /// The whole run, in seconds.
  double total = 0;
};

template <class Visitor>
void visitFields(const Timings& r, Visitor& v) {
  v.field("read", r.read);
  v.field("connectivity", r.connectivity);
  v.field("solve", r.solve);
  v.field("layout", r.layout);
  v.field("refine", r.refine);
  v.field("check", r.check);
  v.field("write", r.write);
  v.field("total", r.total);
}

}  // namespace abflat
