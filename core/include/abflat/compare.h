#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "abflat/flatten.h"
#include "abflat/inspect.h"
#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat {

/// How one method flattens a mesh. Measures are NaN where there is no layout; those that divide by
/// an area are infinite where a triangle has none in uv. Tutte, mean
/// value and harmonic have the boundary on a circle, spaced by 3D edge length; with a fixed
/// boundary harmonic is the discrete conformal parameterization of Desbrun, Meyer and Alliez 2002.
struct MethodResult {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  MethodKey method = MethodKey::AbflatAuto;
  std::string title;   ///< for people
  double seconds = 0;  ///< to lay out, check and measure, without building the connectivity
  double angularDistortion = kUnknown;  ///< mean over corners of ((x - alpha)/alpha)^2
  double lengthDistortion = kUnknown;   ///< mean over edges of (s L/l - 1)^2, s = sum l / sum L
  /// Mean by 3D area of |log(uv area / 3D area)| at equal total area: 0 keeps all areas, log 2 is
  /// off by a factor of two.
  double areaDistortion = kUnknown;
  double areaRatioMin = kUnknown, areaRatioMax = kUnknown;  ///< uv area / 3D area, likewise
  double quasiConformalMean = kUnknown;                     ///< by 3D area, of s1/s2; 1 = conformal
  double quasiConformalMax = kUnknown;
  double symmetricDirichlet = kUnknown;  ///< divided by 4: 1 is an isometry
  std::size_t flippedTriangles = 0;      ///< not positively oriented, by an exact predicate
  std::size_t boundaryCrossings = 0;     ///< by an exact predicate
  bool valid = false;
  std::string problem;     ///< why it is not valid, one sentence; empty when it is
  std::vector<double> uv;  ///< 2 per output vertex, of the mesh's 3D area; empty: no layout
};

struct Comparison {
  MeshSummary input;
  std::vector<MethodResult> methods;     ///< in the order of MethodKey
  std::vector<std::uint32_t> vertexMap;  ///< input vertex of each output vertex
  std::vector<std::uint32_t> triangles;  ///< 3 output vertices per triangle
};

struct CompareOptions {
  /// As in FlattenOptions, with the method at work; `fraction` is that of all.
  ProgressCallback progress;
};

/// Flattens a mesh that is one topological disk by abflat and by the reference methods. A method
/// that fails is a row with its problem; the references are turned to lie as the first layout does.
/// Errors: InvalidMesh, EmptyMesh, DegenerateFace, NonManifoldEdge, InconsistentOrientation,
/// MultipleComponents, ClosedSurface, MultipleBoundaryLoops, HasHandles, Aborted.
Result<Comparison> compare(const PolygonMesh& mesh, const CompareOptions& options);

/// The comparison as JSON text, indented by two spaces, without uv; keys as in docs/methods.md.
/// Numbers that are not finite are null.
std::string compareJson(const Comparison& comparison, const std::string& path);

}  // namespace abflat
