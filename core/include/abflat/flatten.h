#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "abflat/chart_report.h"
#include "abflat/export.h"
#include "abflat/flatten_options.h"
#include "abflat/generated/report.h"
#include "abflat/inspect.h"
#include "abflat/mesh.h"
#include "abflat/mesh_view.h"
#include "abflat/status.h"

namespace abflat {

struct FlattenResult {
  std::vector<double> uv;  ///< 2 per output vertex; total area is the mesh's 3D area unless pinned
  std::vector<std::uint32_t> vertexMap;  ///< input vertex of each output vertex
  std::vector<std::uint32_t> triangles;  ///< 3 output vertices per triangle (polygons triangulated)
  std::vector<std::uint32_t>
      cornerUv;  ///< output vertex of each input face corner (size of faceVertices)
  std::vector<std::uint32_t> straight;  ///< output vertices whose angle was held at pi
  std::vector<VertexBound> bounds;      ///< of output vertices, where bounds were asked for
  Report report;                        ///< the caller fills in path and timings.read/write/total
};

/// Flattens a mesh that is one topological disk (paper, section 5, with bounds t*pi on the
/// boundary). A result that is not valid or did not converge is still returned, with report.valid =
/// false. Errors: InvalidOption, InvalidMesh, EmptyMesh, DegenerateFace, NonManifoldEdge,
/// InconsistentOrientation, MultipleComponents, ClosedSurface, MultipleBoundaryLoops, HasHandles,
/// InfeasibleBound, Aborted.
ABFLAT_API Result<FlattenResult> flatten(const PolygonMesh& mesh, const FlattenOptions& options);

/// The same for triangles in the caller's memory.
ABFLAT_API Result<FlattenResult> flatten(const MeshView& mesh, const FlattenOptions& options);

/// Rounds a valid layout to single precision, which is all that many programs read from a PLY file,
/// and measures it again, so that the report describes the rounded coordinates. If rounding would
/// flip a triangle, make the boundary cross itself, break the Delaunay condition or miss a bound or
/// straight run by more than 0.001 radians, the layout stays as it is and a sentence among the
/// fallbacks says so. Returns whether it was rounded.
ABFLAT_API bool roundToSinglePrecision(const PolygonMesh& mesh, FlattenResult& result);

/// Rounds a layout to what a glTF holds, even if that makes it invalid: single precision, with v
/// from the top. The report then describes the rounded coordinates.
ABFLAT_API void roundForGltf(const PolygonMesh& mesh, FlattenResult& result);

/// The report as JSON text, indented by two spaces; keys as in docs/report.md. Numbers that are not
/// finite are null, and so are counts of an input that could not be read.
ABFLAT_API std::string reportJson(const Report& report);

}  // namespace abflat
