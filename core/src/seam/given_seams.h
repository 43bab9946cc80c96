#pragma once

#include "abflat/seam_sources.h"
#include "cut/cut_surface.h"
#include "mesh/surface_map.h"

namespace abflat {

/// The seams that the user asks for. `hard`: the hard edges. Errors: InvalidOption, naming an edge
/// that does not exist, or what the mesh lacks.
Result<Seams> givenSeams(const SurfaceMap& map, const SeamSources& sources, const Seams& hard);

/// Texcoords of the input's face corners.
struct CornerTexcoords {
  const std::vector<double>& texcoords;        ///< 2 numbers each
  const std::vector<std::uint32_t>& ofCorner;  ///< by InputCorner; kNoTexcoord if it has none
};

/// Whether texcoords are the same on both sides of an edge that has a twin.
bool hasSameTexcoords(const CornerTexcoords& given, const SurfaceMap& map, SurfaceCorner halfEdge);

/// Seams as edges of the input, each listed once with its smaller vertex first.
std::vector<EdgeVertices> seamEdges(const SurfaceMap& map, const Seams& seams);

}  // namespace abflat
