#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "abflat/flatten_options.h"
#include "abflat/generated/names.h"
#include "abflat/newton_step.h"

namespace abflat {

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
  Solver solver = Solver::ActiveSet;
  LinearSolver linearSolver = LinearSolver::Schur;
  Formulation formulation = Formulation::Log;
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

}  // namespace abflat
