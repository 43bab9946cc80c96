#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "abflat/export.h"
#include "abflat/flatten.h"
#include "abflat/generated/method_result.h"
#include "abflat/inspect.h"
#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat {

/// The layouts of a mesh by all methods. Tutte, mean value and harmonic place the boundary on a
/// circle, spaced by 3D edge length; with a fixed boundary, harmonic is the discrete conformal
/// parameterization of Desbrun, Meyer and Alliez 2002.
struct Comparison {
  MeshSummary input;
  std::vector<MethodResult> methods;     ///< in the order of MethodKey
  std::vector<std::uint32_t> vertexMap;  ///< input vertex of each output vertex
  std::vector<std::uint32_t> triangles;  ///< 3 output vertices per triangle
};

struct CompareOptions {
  /// As in FlattenOptions, plus the method at work; `fraction` covers all methods.
  ProgressCallback progress;
};

/// Flattens a mesh that is one topological disk by abflat and by the reference methods. A method
/// that fails still has a row, with its problem; the reference layouts are rotated to match the
/// first one. Errors: InvalidMesh, EmptyMesh, DegenerateFace, NonManifoldEdge,
/// InconsistentOrientation, MultipleComponents, ClosedSurface, MultipleBoundaryLoops, HasHandles,
/// Aborted.
ABFLAT_API Result<Comparison> compare(const PolygonMesh& mesh, const CompareOptions& options);

/// The comparison as JSON text, indented by two spaces, without uv; keys as in docs/report.md.
/// Numbers that are not finite are null.
ABFLAT_API std::string compareJson(const Comparison& comparison, const std::string& path);

}  // namespace abflat
