#pragma once

#include <cstdint>
#include <vector>

#include "abflat/export.h"
#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat {

/// A layout in the plane, some of whose vertices are pinned.
struct PinnedMesh {
  PolygonMesh mesh;                 ///< triangles; a vertex on a seam is there once for each side
  std::vector<double> uv;           ///< 2 per vertex
  std::vector<std::uint32_t> pins;  ///< vertices; the first one is dragged, the others stay
};

/// How each vertex follows the dragged pin: weights (a, b), 2 numbers per vertex. When the pin
/// moves by (du, dv), the vertex moves by (a du - b dv, b du + a dv). So one solve is enough for a
/// whole drag.
///
/// The moved layout is the one that pinLayout finds, with angles of the surface: one pin moves
/// everything, two give a similarity, and more distribute what a similarity leaves by minimising
/// the conformal energy. All of this is linear in the pins, and turns with them, so that weights
/// are complex numbers a + ib. Errors: those of validateArrays; InvalidOption for polygons, for a
/// wrong number of uv, for pins that do not exist, are there twice or are at one place, and for a
/// singular system.
ABFLAT_API Result<std::vector<double>> pinWeights(const PinnedMesh& layout);

}  // namespace abflat
